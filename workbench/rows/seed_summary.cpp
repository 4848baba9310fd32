#include "rows/seed_summary.h"

#include <algorithm>

namespace coppice::lab {

namespace {

template <typename Value>
SeedMean mean_over(const std::vector<const ResultRow*>& rows, Value&& value) {
    std::vector<double> values;
    double sum = 0.0;
    for (const ResultRow* row : rows) {
        values.push_back(value(*row));
        sum += values.back();
    }
    const std::optional<Interval> interval = mean_interval(values);
    return {interval ? interval->mean : sum / static_cast<double>(values.size()), interval};
}

RateSummary summary_of(const std::vector<const ResultRow*>& rows) {
    const ResultRow& first = *rows.front();
    RateSummary summary{
        first.primitives,
        first.protocol,
        first.sample_percent,
        rows.size(),
        mean_over(rows, [](const ResultRow& r) { return r.report.statistics.sah_cost; }),
        mean_over(rows, [](const ResultRow& r) { return r.relative_cost; }),
        mean_over(rows, [](const ResultRow& r) { return r.report.stages.wall_seconds(); }),
        mean_over(rows, [](const ResultRow& r) { return r.relative_time; }),
        first.sampler,
        first.form,
        std::nullopt};
    if (nanoseconds_of(first.rays)) {
        summary.ray_nanoseconds = mean_over(
            rows, [](const ResultRow& r) { return nanoseconds_of(r.rays).value_or(0.0); });
    }
    return summary;
}

}  // namespace

std::vector<RateSummary> summarize_seeds(std::span<const ResultRow> rows) {
    std::vector<std::vector<const ResultRow*>> groups;
    for (const ResultRow& row : rows) {
        const auto at = std::find_if(groups.begin(), groups.end(), [&](const auto& group) {
            return group.front()->is_twin_of(row);
        });
        if (at == groups.end()) {
            groups.push_back({&row});
        } else {
            at->push_back(&row);
        }
    }
    std::vector<RateSummary> summaries;
    std::transform(groups.begin(), groups.end(), std::back_inserter(summaries), summary_of);
    return summaries;
}

}  // namespace coppice::lab
