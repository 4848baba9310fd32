#pragma once

#include "rows/results.h"
#include "statistics/confidence.h"

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace coppice::lab {

/// A measure over the seeds.
struct SeedMean {
    double mean = 0.0;
    std::optional<Interval> interval;  ///< of the mean; nothing for one seed
};

/// The trees of one series at one percentage, one for each seed.
struct RateSummary : TreeSeries {
    double sample_percent = 100.0;
    std::size_t seed_count = 0;
    SeedMean sah_cost;
    SeedMean relative_cost;  ///< each seed's over that seed's 100 % tree
    SeedMean total_seconds;
    SeedMean relative_time;  ///< the same
    TreeForm form = TreeForm::kd;
    /// Nanoseconds of wall-clock time a ray, of all kinds traced; nothing if none were.
    std::optional<SeedMean> ray_nanoseconds;
};

/// Means and intervals over the seeds of the rows of one scene, in the order of the rows.
[[nodiscard]] std::vector<RateSummary> summarize_seeds(std::span<const ResultRow> rows);

}  // namespace coppice::lab
