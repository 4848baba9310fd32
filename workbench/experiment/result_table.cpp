#include "experiment/result_table.h"

#include "experiment/builders.h"
#include "rows/group_by.h"
#include "rows/recommend.h"
#include "rows/seed_summary.h"
#include "statistics/mean.h"
#include "text/numbers.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <vector>

namespace coppice::lab {

namespace {

using RowGroup = Group<ResultRow>;

/// The mean over the seeds.
template <typename Value>
double mean_over(const RowGroup& rows, Value&& value) {
    std::vector<double> values;
    for (const ResultRow* row : rows) {
        values.push_back(static_cast<double>(value(*row)));
    }
    return mean_of(values);
}

std::string cost_text(double cost) {
    if (!std::isfinite(cost)) return "-";
    const bool is_plain = cost >= 0.01 && cost < 1e6;
    return is_plain ? fmt::format("{:.2f}", cost) : fmt::format("{:.3g}", cost);
}

std::string relative_text(double relative) {
    return fixed_text(relative, 3);
}

/// Seven columns at most, down to a hundredth of a millisecond.
std::string tree_seconds(double seconds) {
    return fmt::format("{:.{}f}", seconds, seconds < 0.01 ? 5 : seconds < 1000.0 ? 3 : 0);
}

/// Half the width of an interval: "0.012".
std::string reach_text(const SeedMean& measure) {
    return measure.interval ? relative_text(measure.interval->high - measure.mean) : "-";
}

/// Behind the relative cost: how sure it is, and the relative time.
std::string confidence_text(const RateSummary& summary) {
    return fmt::format(" +-{:<6} {:>6} +-{}", reach_text(summary.relative_cost),
                       relative_text(summary.relative_time.mean),
                       reach_text(summary.relative_time));
}

constexpr const char* result_line =
    "{:1} {:>5} {:>9} {:>9} {:>6} {:>10} {:>7} {:>7} {:>7} {:>7} {:>7} {:>7} {:>9} {:>8}";

std::string header_line() {
    return fmt::format(result_line, "", "", "", "", "", "", "sample", "build", "empty", "refill",
                       "refine", "total", "", "relative") +
           '\n' +
           fmt::format(result_line, "", "%", "nodes", "leaves", "levels", "references", "s", "s",
                       "s", "s", "s", "s", "cost", "cost");
}

std::string group_line(const RowGroup& group, bool is_recommended) {
    const bool is_peer = group.front()->form == TreeForm::peer;
    const auto count = [&](auto&& value) {
        return is_peer ? std::string("-") : fmt::format("{:.0f}", mean_over(group, value));
    };
    const auto seconds = [&](StageReport StageReports::*stage) {
        return tree_seconds(mean_over(
            group, [&](const ResultRow& row) { return (row.report.stages.*stage).wall_seconds; }));
    };
    const auto statistic = [](auto TreeStatistics::*member) {
        return [member](const ResultRow& row) { return row.report.statistics.*member; };
    };
    const double total =
        mean_over(group, [](const ResultRow& r) { return r.report.stages.wall_seconds(); });
    const double relative = mean_over(group, [](const ResultRow& r) { return r.relative_cost; });
    return fmt::format(
        result_line, is_recommended ? "*" : "", group.front()->sample_percent,
        count(statistic(&TreeStatistics::node_count)),
        count(statistic(&TreeStatistics::leaf_count)), count(statistic(&TreeStatistics::max_level)),
        count(statistic(&TreeStatistics::reference_count)), seconds(&StageReports::sample),
        seconds(&StageReports::build), seconds(&StageReports::empty),
        seconds(&StageReports::refill), seconds(&StageReports::refine), tree_seconds(total),
        cost_text(mean_over(group, statistic(&TreeStatistics::sah_cost))), relative_text(relative));
}

const Recommendation* find_recommendation(const SceneResult& scene, const ResultRow& row) {
    for (const Recommendation& recommendation : scene.recommended) {
        if (recommendation.series() == row.series()) return &recommendation;
    }
    return nullptr;
}

/// Whether the protocols' rows are of several samplers, as the first protocol's tell.
bool has_samplers(const SceneResult& scene) {
    if (scene.rows.empty()) return false;
    const ResultRow& first = scene.rows.front();
    return std::any_of(scene.rows.begin(), scene.rows.end(), [&](const ResultRow& row) {
        return row.protocol == first.protocol && row.sampler != first.sampler;
    });
}

/// What a table starts with: the scene, the kind, and what all its protocols' rows share.
std::string title(const ResultRow& row, bool has_one_sampler, std::size_t seed_count) {
    std::string text =
        fmt::format("{}, {}: {} primitives, {} splits", row.scene, row.primitives,
                    row.report.primitive_count, std::get<KdOptions>(row.report.options).split.rule);
    if (has_one_sampler) text += fmt::format(", {} sample", row.sampler);
    if (seed_count > 1) {
        text += fmt::format(
            ", means of {} seeds;\nlast columns: cost and time over the 100 % tree's of the same "
            "seed, "
            "+- half the {}",
            seed_count, interval_name);
    }
    return text + '\n';
}

/// What the rows of one builder and sampler start with.
std::string section_line(const ResultRow& row, bool names_sampler) {
    std::string text = row.protocol;
    if (names_sampler) text += fmt::format(", {} sample", row.sampler);
    text += fmt::format(": {}", builder_summary(row.protocol));
    if (row.form == TreeForm::bvh8) text += "; a test is of 8 triangles";
    return text + '\n';
}

/// What a recommended sample does not give.
std::string choice_note(const Recommendation& choice) {
    if (choice.chosen.percent == 100.0) return ": no smaller sample is good enough";
    if (choice.saves_time()) return "";
    return choice.chosen.time < 1.0 ? ": whether it saves time is within noise"
                                    : ": it saves no time";
}

/// `is_rule`: these are recommended.
std::string choice_lines(std::span<const Recommendation> choices, bool names_sampler,
                         bool is_rule) {
    std::string text;
    for (const Recommendation& choice : choices) {
        const std::string how = names_sampler
                                    ? fmt::format("{}, {}", choice.protocol, choice.sampler)
                                    : choice.protocol;
        text += fmt::format("  {}, {}: {} % (cost x {}, time x {}){}\n", choice.primitives, how,
                            choice.chosen.percent, relative_text(choice.chosen.cost),
                            relative_text(choice.chosen.time), is_rule ? choice_note(choice) : "");
    }
    return text.empty() ? "  none\n" : text;
}

}  // namespace

std::string result_rows(const SceneResult& scene, std::size_t first) {
    const auto groups =
        group_by(std::span<const ResultRow>(scene.rows),
                 [](const ResultRow& a, const ResultRow& b) { return a.is_twin_of(b); });
    const std::vector<RateSummary> summaries = summarize_seeds(scene.rows);  // in the same order
    const bool names_sampler = has_samplers(scene);
    std::string text;
    const ResultRow* last = first > 0 ? &scene.rows[first - 1] : nullptr;
    for (std::size_t at = 0; at < groups.size(); ++at) {
        const RowGroup& group = groups[at];
        const ResultRow& row = *group.front();
        if (&row < scene.rows.data() + first) continue;
        const bool is_new_kind = last == nullptr || row.primitives != last->primitives;
        if (is_new_kind) {
            if (last != nullptr) text += '\n';
            text += title(row, !names_sampler, group.size()) + header_line() + '\n';
        }
        const bool is_new_section =
            is_new_kind || row.protocol != last->protocol || row.sampler != last->sampler;
        if (is_new_section) {
            const bool is_usual = row.sampler == scene.rows.front().sampler;
            text += section_line(row, !row.sampler.empty() && (names_sampler || !is_usual));
        }
        last = &row;
        const Recommendation* chosen = find_recommendation(scene, row);
        text +=
            group_line(group, chosen != nullptr && chosen->chosen.percent == row.sample_percent);
        text += group.size() > 1 ? confidence_text(summaries[at]) + '\n' : "\n";
    }
    return text;
}

std::string result_choices(const SceneResult& scene, double tolerance) {
    if (scene.rows.empty()) return {};
    const bool names_sampler = has_samplers(scene);
    const auto seed_count = static_cast<int>(summarize_seeds(scene.rows).front().seed_count);
    return fmt::format(
        "\n* recommended: {}\n{}knee: the greatest saving of time per added cost (Kneedle)\n{}",
        recommendation_rule(tolerance, seed_count),
        choice_lines(scene.recommended, names_sampler, true),
        choice_lines(scene.knees, names_sampler, false));
}

}  // namespace coppice::lab
