#include "lab/result_table.h"

#include "lab/protocol.h"
#include "lab/recommend.h"
#include "lab/seed_summary.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <vector>

namespace coppice::lab {

namespace {

/// The rows of one kind, protocol and percentage: one per seed, at least one.
struct Group {
    std::vector<const ResultRow*> rows;

    [[nodiscard]] const ResultRow& first() const { return *rows.front(); }

    template <typename Value>
    [[nodiscard]] double mean(Value&& value) const {
        double sum = 0.0;
        for (const ResultRow* row : rows) {
            sum += static_cast<double>(value(*row));
        }
        return sum / static_cast<double>(rows.size());
    }
};

std::vector<Group> group_by_percent(const std::vector<ResultRow>& rows) {
    std::vector<Group> groups;
    for (const ResultRow& row : rows) {
        const auto same = [&](const Group& group) {
            const ResultRow& first = group.first();
            return first.primitives == row.primitives && first.protocol == row.protocol &&
                   first.sample_percent == row.sample_percent;
        };
        const auto at = std::find_if(groups.begin(), groups.end(), same);
        if (at == groups.end()) {
            groups.push_back({{&row}});
        } else {
            at->rows.push_back(&row);
        }
    }
    return groups;
}

std::string cost_text(double cost) {
    if (!std::isfinite(cost)) return "-";
    const bool is_plain = cost >= 0.01 && cost < 1e6;
    return is_plain ? fmt::format("{:.2f}", cost) : fmt::format("{:.3g}", cost);
}

std::string relative_text(double relative) {
    return std::isfinite(relative) ? fmt::format("{:.3f}", relative) : "-";
}

/// Seven columns at most, down to a hundredth of a millisecond.
std::string seconds_text(double seconds) {
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

constexpr const char* line_format =
    "{:1} {:>5} {:>9} {:>9} {:>6} {:>10} {:>7} {:>7} {:>7} {:>7} {:>7} {:>7} {:>9} {:>8}";

std::string header_line() {
    return fmt::format(line_format, "", "", "", "", "", "", "sample", "build", "empty", "refill",
                       "refine", "total", "", "relative") +
           '\n' +
           fmt::format(line_format, "", "%", "nodes", "leaves", "levels", "references", "s", "s",
                       "s", "s", "s", "s", "cost", "cost");
}

std::string group_line(const Group& group, bool is_recommended) {
    const auto count = [&](auto&& value) { return fmt::format("{:.0f}", group.mean(value)); };
    const auto seconds = [&](StageReport StageReports::*stage) {
        return seconds_text(group.mean(
            [&](const ResultRow& row) { return (row.report.stages.*stage).wall_seconds; }));
    };
    const auto statistic = [](auto TreeStatistics::*member) {
        return [member](const ResultRow& row) { return row.report.statistics.*member; };
    };
    const double total =
        group.mean([](const ResultRow& r) { return r.report.stages.wall_seconds(); });
    const double relative = group.mean([](const ResultRow& r) { return r.relative_cost; });
    return fmt::format(
        line_format, is_recommended ? "*" : "", group.first().sample_percent,
        count(statistic(&TreeStatistics::node_count)),
        count(statistic(&TreeStatistics::leaf_count)), count(statistic(&TreeStatistics::max_level)),
        count(statistic(&TreeStatistics::reference_count)), seconds(&StageReports::sample),
        seconds(&StageReports::build), seconds(&StageReports::empty),
        seconds(&StageReports::refill), seconds(&StageReports::refine), seconds_text(total),
        cost_text(group.mean(statistic(&TreeStatistics::sah_cost))), relative_text(relative));
}

const Recommendation* find_recommendation(const SceneResult& scene, const ResultRow& row) {
    for (const Recommendation& recommendation : scene.recommended) {
        if (recommendation.primitives == row.primitives &&
            recommendation.protocol == row.protocol) {
            return &recommendation;
        }
    }
    return nullptr;
}

/// What a table starts with: the scene, the kind, and what all its rows share.
std::string title(const ResultRow& row, std::size_t seed_count) {
    std::string text =
        fmt::format("{}, {}: {} primitives, {} splits, {} sample", row.scene, row.primitives,
                    row.report.primitive_count, row.report.options.split.rule,
                    row.report.options.sample.sampler);
    if (seed_count > 1) {
        text += fmt::format(
            ", means of {} seeds;\nlast columns: cost and time over the 100 % tree's of the same "
            "seed, "
            "+- half the {}",
            seed_count, interval_name);
    }
    return text + '\n';
}

std::string choice_lines(std::span<const Recommendation> choices) {
    std::string text;
    for (const Recommendation& choice : choices) {
        text += fmt::format("  {}, {}: {} % (cost x {}, time x {})\n", choice.primitives,
                            choice.protocol, choice.chosen.percent,
                            relative_text(choice.chosen.cost), relative_text(choice.chosen.time));
    }
    return text.empty() ? "  none\n" : text;
}

std::string recommendation_lines(const SceneResult& scene, double tolerance, int seed_count) {
    return fmt::format(
        "* recommended: {}\n{}knee: the greatest saving of time per added cost (Kneedle)\n{}",
        recommendation_rule(tolerance, seed_count), choice_lines(scene.recommended),
        choice_lines(scene.knees));
}

}  // namespace

std::string result_table(const SceneResult& scene, double tolerance) {
    if (scene.rows.empty()) return {};
    const std::vector<RateSummary> summaries = summarize_seeds(scene.rows);
    auto summary = summaries.begin();  // in the order of the groups
    std::string text;
    std::string_view primitives;
    std::string_view protocol;
    for (const Group& group : group_by_percent(scene.rows)) {
        const ResultRow& row = group.first();
        const bool has_seeds = group.rows.size() > 1;
        if (row.primitives != primitives) {
            if (!text.empty()) text += '\n';
            text += title(row, group.rows.size()) + header_line() + '\n';
            protocol = {};
        }
        if (row.protocol != protocol) {
            text += fmt::format("{}: {}\n", row.protocol, find_protocol(row.protocol).summary);
        }
        primitives = row.primitives;
        protocol = row.protocol;
        const Recommendation* chosen = find_recommendation(scene, row);
        text +=
            group_line(group, chosen != nullptr && chosen->chosen.percent == row.sample_percent);
        text += has_seeds ? confidence_text(*summary) + '\n' : "\n";
        ++summary;
    }
    const auto seed_count = static_cast<int>(summaries.front().seed_count);
    return text + '\n' + recommendation_lines(scene, tolerance, seed_count);
}

}  // namespace coppice::lab
