#include "report/summary.h"

#include "report/chart_parts.h"
#include "report/format.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

namespace coppice::report {
namespace {

using nlohmann::json;

std::string strong(const std::string& html) {
    return "<strong>" + html + "</strong>";
}

std::string name_of(std::string_view protocol) {
    return escape_html(protocol_style(protocol).name);
}

// "1.03 to 1.21", or one number where both look the same.
std::string from_to(double least, double greatest) {
    const std::string low = format_ratio(least);
    const std::string high = format_ratio(greatest);
    return low == high ? low : low + " to " + high;
}

// " (95 % interval 1.68 to 1.74 of 3 seeds)", where there are several.
std::string spread(const Range& ratio, std::size_t seed_count) {
    if (seed_count <= 1) return {};
    return ratio.interval
               ? fmt::format(" (95 % interval {} of {} seeds)",
                             from_to(ratio.interval->front(), ratio.interval->back()), seed_count)
               : fmt::format(" ({} over {} seeds)", from_to(ratio.min, ratio.max), seed_count);
}

// "1.71 times", with the spread over the seeds where there are several.
std::string times(const Range& ratio, std::size_t seed_count) {
    return format_ratio(ratio.mean) + " times" + spread(ratio, seed_count);
}

// The protocol's point with the smallest sample.
const RatePoint* smallest_sample(const Series& series, std::string_view protocol) {
    const RatePoint* smallest = nullptr;
    for (const RatePoint& point : series.points) {
        if (point.protocol == protocol) smallest = &point;
    }
    return smallest;
}

struct Ends {
    double least = 0.0;
    double greatest = 0.0;
};

// An array of two numbers, if it is one.
std::optional<Ends> interval_at(const json& row, const char* key) {
    const json& ends = array_at(row, key);
    if (ends.size() != 2 || !ends[0].is_number() || !ends[1].is_number()) return std::nullopt;
    return Ends{ends[0].get<double>(), ends[1].get<double>()};
}

// Which tree a scene's results recommend the most.
struct Choice {
    const Series* series = nullptr;
    std::string protocol;
    double percent = 100.0;
    std::optional<double> relative_cost;
    std::optional<double> relative_time;
    std::optional<Ends> time_interval;  // 95 %
};

// The smallest sample recommended for one kind, and of equal ones the cheapest tree.
std::optional<Choice> best_of_kind(const json& scene, const Series& series) {
    std::optional<Choice> best;
    for (const json& row : array_at(scene, "recommended")) {
        const std::optional<double> percent = number_at(row, "sample_percent");
        const std::string line = series.line_of(row);
        const bool is_here = text_at(row, "primitives") == series.kind &&
                             std::ranges::count(series.protocols(), line) > 0;
        if (!is_here || !percent) continue;
        const Choice choice{&series,
                            line,
                            *percent,
                            number_at(row, "relative_cost"),
                            number_at(row, "relative_time"),
                            interval_at(row, "relative_time_interval")};
        const auto rank = [](const Choice& one) {
            return std::pair(one.percent, one.relative_cost.value_or(1.0));
        };
        if (!best || rank(choice) < rank(*best)) best = choice;
    }
    return best;
}

// That of triangles, which rays are traced against, or of the first kind that has one.
std::optional<Choice> best_choice(const json& scene, const std::vector<Series>& series) {
    std::optional<Choice> best;
    for (const Series& kind : series) {
        if (best && kind.kind != "triangles") continue;
        if (const auto choice = best_of_kind(scene, kind)) best = choice;
    }
    return best;
}

// " (95 % interval 60.1 % to 102 %, so that it may save none)"
std::string time_spread(const Choice& choice) {
    if (!choice.time_interval || choice.percent == 100.0) return {};
    const auto [least, greatest] = *choice.time_interval;
    return fmt::format(" (95 % interval {} to {}{})", format_share(std::max(least, 0.0)),
                       format_share(greatest),
                       least < 1.0 && greatest >= 1.0 ? ", so that it may save none" : "");
}

// "the tree costs 1.01 times (95 % interval ...) as much as the full one".
std::string choice_consequence(const Choice& choice) {
    std::vector<std::string> phrases;
    const RatePoint* point = choice.series->find(choice.protocol, choice.percent);
    const Range* cost = point != nullptr ? point->find("relative_cost") : nullptr;
    if (cost != nullptr) {
        phrases.push_back(fmt::format("costs {}{} as much as the full one", strong(times(*cost, 1)),
                                      spread(*cost, point->seed_count)));
    } else if (choice.relative_cost) {
        phrases.push_back(fmt::format("costs {} as much as the full one",
                                      strong(format_ratio(*choice.relative_cost) + " times")));
    }
    if (choice.relative_time) {
        phrases.push_back(fmt::format("takes {}{} of its build time",
                                      strong(format_share(*choice.relative_time)),
                                      time_spread(choice)));
    }
    return phrases.empty() ? "" : ": the tree " + join_words(phrases);
}

std::string cost_sentence(const Series& series, const RatePoint& point) {
    const Range* relative = point.find("relative_cost");
    if (relative == nullptr || point.percent == 100.0) {
        const Range* cost = point.find("sah_cost");
        return fmt::format("the tree built on {} has the SAH cost {}.",
                           format_percent(point.percent),
                           cost != nullptr ? format_ratio(cost->mean) : "–");
    }
    std::string text =
        fmt::format("the tree built on {} costs {} as much as its own full tree",
                    format_percent(point.percent), strong(times(*relative, point.seed_count)));
    if (const auto time = series.relative_time(point)) {
        text += fmt::format(" and takes {} of that one’s build time", format_share(*time));
    }
    const RatePoint* half = series.find(point.protocol, 50.0);
    if (half != nullptr && half != &point && half->find("relative_cost") != nullptr) {
        text += fmt::format("; at the thesis’s choice of 50&nbsp;% the cost is {}",
                            times(*half->find("relative_cost"), half->seed_count));
    }
    return text + ".";
}

// The mean level of the leaves.
std::optional<double> mean_leaf_level(const RatePoint& point) {
    const auto at = point.levels.find("depth_histogram");
    if (at == point.levels.end()) return std::nullopt;
    double leaves = 0.0;
    double levels = 0.0;
    for (std::size_t level = 0; level < at->second.size(); ++level) {
        leaves += at->second[level];
        levels += at->second[level] * static_cast<double>(level);
    }
    return leaves > 0.0 ? std::optional(levels / leaves) : std::nullopt;
}

// How the tree's shape changed against the full one of the same protocol.
std::string shape_sentence(const Series& series, const RatePoint& point) {
    const RatePoint* full = series.find(point.protocol, 100.0);
    if (full == nullptr || full == &point) return {};
    const Range* leaf = point.find("mean_leaf_size");
    const Range* full_leaf = full->find("mean_leaf_size");
    const std::optional<double> level = mean_leaf_level(point);
    const std::optional<double> full_level = mean_leaf_level(*full);
    if (leaf == nullptr || full_leaf == nullptr || !level || !full_level) return {};
    std::string text = fmt::format(
        " On average its leaves lie at level {} (full tree: {}) and hold {} primitives (full tree:"
        " {}).",
        format_ratio(*level), format_ratio(*full_level), format_ratio(leaf->mean),
        format_ratio(full_leaf->mean));
    if (point.protocol == "fixed" && leaf->mean > full_leaf->mean) {
        text += fmt::format(
            " With the limit unchanged, a sample of rate r is expected to stop splitting"
            " log₂(1/r) = {} levels early: every leaf then takes in what those levels would have"
            " divided.",
            format_ratio(std::log2(100.0 / point.percent)));
    }
    return text;
}

// What the protocols cost against each other before any sampling.
std::string control_item(const Series& series) {
    const std::vector<std::string> protocols = series.protocols();
    const RatePoint* first = series.find(protocols.front(), 100.0);
    const Range* cost = first != nullptr ? first->find("sah_cost") : nullptr;
    if (cost == nullptr || !(cost->mean > 0.0)) return {};
    std::vector<std::string> phrases;
    for (const std::string& protocol : protocols) {
        const RatePoint* full = series.find(protocol, 100.0);
        const Range* other = full != nullptr ? full->find("sah_cost") : nullptr;
        if (full == first || other == nullptr) continue;
        phrases.push_back(
            fmt::format("{} {}", name_of(protocol), format_ratio(other->mean / cost->mean)));
    }
    if (phrases.empty()) return {};
    return fmt::format(
        "<li><b>Control.</b> Without any sampling, at 100&nbsp;%, the SAH cost is {} with a {}; "
        "relative"
        " to that: {}.</li>",
        format_ratio(cost->mean), name_of(protocols.front()), join_words(phrases));
}

// Over the thesis's scenes, the least and the greatest of what `measure` makes of a row and the
// 100 % row of its scene.
template <typename MeasureRatio>
std::optional<Ends> thesis_ends(const ThesisTables& thesis, double percent, MeasureRatio measure) {
    std::optional<Ends> ends;
    for (const std::string& scene : thesis.scenes()) {
        const ThesisRow* row = thesis.find(scene, percent);
        const ThesisRow* full = thesis.find(scene, 100.0);
        if (row == nullptr || full == nullptr) continue;
        const double ratio = measure(*row, *full);
        if (!ends) ends = Ends{ratio, ratio};
        ends->least = std::min(ends->least, ratio);
        ends->greatest = std::max(ends->greatest, ratio);
    }
    return ends;
}

double cost_ratio(const ThesisRow& row, const ThesisRow& full) {
    return row.sah_cost / full.sah_cost;
}

// A binary tree of n nodes has (n + 1) / 2 leaves.
double leaf_ratio(const ThesisRow& row, const ThesisRow& full) {
    return (full.node_count + 1.0) / (row.node_count + 1.0);
}

// "1.71 times with a fixed leaf limit and 1.14 times with ..." at a percentage.
std::string our_costs(const Series& series, double percent) {
    std::vector<std::string> phrases;
    for (const std::string& protocol : series.protocols()) {
        const RatePoint* point = series.find(protocol, percent);
        const Range* cost = point != nullptr ? point->find("relative_cost") : nullptr;
        if (cost == nullptr) continue;
        phrases.push_back(fmt::format("{} ({})", format_ratio(cost->mean), name_of(protocol)));
    }
    return join_words(phrases);
}

// The smallest percentage below 100 that both have, if any.
std::optional<double> smallest_common_percent(const Series& series, const ThesisTables& thesis) {
    std::optional<double> smallest;
    for (const double percent : series.percents()) {
        const bool is_shared = std::ranges::any_of(
            thesis.rows, [&](const ThesisRow& row) { return row.percent == percent; });
        if (is_shared && percent < 100.0) smallest = percent;
    }
    return smallest;
}

// Solves (V + k T) / (V_full + k T_full) = ratio for k = t_isect / t_trav, V and T being the
// expected inner visits and primitive tests of the fixed protocol. The left side grows with k as
// long as T / T_full > V / V_full, so k is the most a test may be charged.
std::optional<double> greatest_test_charge(const Series& series, double percent, double ratio) {
    const RatePoint* point = series.find("fixed", percent);
    const RatePoint* full = series.find("fixed", 100.0);
    if (point == nullptr || full == nullptr) return std::nullopt;
    const Range* visits = point->find("expected_inner_visits");
    const Range* tests = point->find("expected_primitive_tests");
    const Range* full_visits = full->find("expected_inner_visits");
    const Range* full_tests = full->find("expected_primitive_tests");
    if (visits == nullptr || tests == nullptr || full_visits == nullptr || full_tests == nullptr) {
        return std::nullopt;
    }
    const double spare_visits = ratio * full_visits->mean - visits->mean;
    const double extra_tests = tests->mean - ratio * full_tests->mean;
    if (!(spare_visits > 0.0) || !(extra_tests > 0.0)) return std::nullopt;
    return spare_visits / extra_tests;
}

// Why the thesis's costs differ: what its own node counts say, and what our counts say.
std::string explain_costs(const Series& series, const ThesisTables& thesis, double percent) {
    const std::optional<Ends> costs = thesis_ends(thesis, percent, cost_ratio);
    const std::optional<Ends> leaves = thesis_ends(thesis, percent, leaf_ratio);
    if (!costs || !leaves) return {};
    std::string text = fmt::format(
        "<p>The thesis does not state its constants, and its costs rise less than its trees allow:"
        " by its own node counts, once all primitives are back, a leaf of its {} trees holds {}"
        " times as many of them as a leaf of the full tree, and equation (4) charges"
        " t<sub>isect</sub> for each.",
        format_percent(percent), from_to(leaves->least, leaves->greatest));
    const RatePoint* point = series.find("fixed", percent);
    const RatePoint* full = series.find("fixed", 100.0);
    if (point != nullptr && full != nullptr && point->find("relative_cost") != nullptr) {
        if (const auto leaf = series.relative_to_full(*point, "mean_leaf_size")) {
            text += fmt::format(
                " Here, at {} with a fixed leaf limit, the mean leaf grows {} times and the cost {}"
                " times.",
                format_percent(percent), format_ratio(*leaf),
                format_ratio(point->find("relative_cost")->mean));
        }
    }
    if (const auto charge = greatest_test_charge(series, percent, costs->greatest)) {
        text += fmt::format(
            " With the visits and tests expected here, even the steepest rise of the thesis ({}"
            " times) would need a test to be charged {} of a step down the tree or less; pbrt-v3"
            " charges 80 steps. Its table is therefore hardly the cost of trees that hold all"
            " their primitives again.",
            format_ratio(costs->greatest), format_ratio(*charge));
    }
    return text + "</p>";
}

}  // namespace

std::string make_answer(const json& scene, const std::vector<Series>& series) {
    if (series.empty()) return "<p class=\"answer\">No tree was built for this scene.</p>";
    const std::optional<Choice> choice = best_choice(scene, series);
    if (!choice) {
        return "<p class=\"answer\">The results recommend no percentage for this scene.</p>";
    }
    const std::string kind = escape_html(choice->series->kind);
    const std::string protocol = name_of(choice->protocol);
    std::string text = "<p class=\"answer\">Build on ";
    if (choice->percent < 100.0) {
        text += fmt::format("{} of the {} ({}){}.", strong(format_percent(choice->percent)), kind,
                            protocol, choice_consequence(*choice));
    } else {
        text += fmt::format("{} of the {}: no smaller sample will do, by the rule below.",
                            strong(format_percent(choice->percent)), kind);
    }
    const json& first = array_at(scene, "recommended").front();
    text += fmt::format(" <span class=\"rule\">Rule: {}",
                        escape_html(capitalize(text_at(first, "rule"))));
    if (const std::string source = text_at(first, "source"); !source.empty()) {
        text += ", " + escape_html(source);
    }
    return text + ".</span></p>";
}

std::string make_findings(const Series& series) {
    std::string items;
    for (const std::string& protocol : series.protocols()) {
        const RatePoint* point = smallest_sample(series, protocol);
        items += fmt::format("<li><b>{}:</b> {}{}</li>", capitalize(name_of(protocol)),
                             cost_sentence(series, *point), shape_sentence(series, *point));
    }
    return "<ul class=\"findings\">" + items + control_item(series) + "</ul>";
}

std::string make_thesis_comparison(const Series& series, const ThesisTables& thesis) {
    if (!series.has_relative_cost()) {
        return "<p>These results have no 100&nbsp;% trees to be relative to, so only the thesis’s "
               "own"
               " numbers are shown.</p>";
    }
    const std::optional<double> percent = smallest_common_percent(series, thesis);
    if (!percent) {
        return "<p>These results share no percentage below 100&nbsp;% with the thesis.</p>";
    }
    std::string text = "<p>";
    for (const double at : {50.0, *percent}) {
        const std::optional<Ends> costs = thesis_ends(thesis, at, cost_ratio);
        const std::string ours = our_costs(series, at);
        if (!costs || ours.empty() || (at == 50.0 && *percent == 50.0)) continue;
        text += fmt::format(
            "At {} the thesis reports {} times the cost of the full tree on its four scenes; the {}"
            " of {} give {}. ",
            format_percent(at), from_to(costs->least, costs->greatest), escape_html(series.kind),
            escape_html(series.scene), ours);
    }
    text += "</p>" + explain_costs(series, thesis, *percent);
    return text;
}

}  // namespace coppice::report
