#include "rows/seed_summary.h"

#include "rows/group_by.h"
#include "statistics/mean.h"

#include <algorithm>

namespace coppice::lab {

namespace {

template <typename Value>
SeedMean mean_over(const Group<ResultRow>& rows, Value&& value) {
    std::vector<double> values;
    for (const ResultRow* row : rows) {
        values.push_back(value(*row));
    }
    const std::optional<Interval> interval = mean_interval(values);
    return {interval ? interval->mean : mean_of(values), interval};
}

RateSummary summary_of(const Group<ResultRow>& rows) {
    const ResultRow& first = *rows.front();
    RateSummary summary{
        first.series(),
        first.sample_percent,
        rows.size(),
        mean_over(rows, [](const ResultRow& r) { return r.report.statistics.sah_cost; }),
        mean_over(rows, [](const ResultRow& r) { return r.relative_cost; }),
        mean_over(rows, [](const ResultRow& r) { return r.report.stages.wall_seconds(); }),
        mean_over(rows, [](const ResultRow& r) { return r.relative_time; }),
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
    const auto groups =
        group_by(rows, [](const ResultRow& a, const ResultRow& b) { return a.is_twin_of(b); });
    std::vector<RateSummary> summaries;
    std::transform(groups.begin(), groups.end(), std::back_inserter(summaries), summary_of);
    return summaries;
}

}  // namespace coppice::lab
