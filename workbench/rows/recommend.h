#pragma once

#include "rows/results.h"
#include "rows/seed_summary.h"

#include <span>
#include <string>
#include <vector>

namespace coppice::lab {

/// Of each kind of primitive, protocol and sampler of one scene the smallest sample whose cost is
/// within `tolerance` (a share, >= 0) of the full tree's with 95 % confidence: the upper end of the
/// interval of its relative cost is at most 1 + tolerance. Of one seed, which gives no interval,
/// the cost itself is taken. Nothing where there is no such sample, no sampling, or the full tree
/// alone. In the order of the summaries.
[[nodiscard]] std::vector<Recommendation> recommend(std::span<const RateSummary> summaries,
                                                    double tolerance);

/// The same rule in words, for as many seeds.
[[nodiscard]] std::string recommendation_rule(double tolerance, int seed_count);

/// The knee (find_knee()) of the curve of cost against total time of each kind of primitive,
/// protocol and sampler, both relative to the 100 % tree and averaged over the seeds; of at least
/// two rates. In the order of the summaries.
[[nodiscard]] std::vector<Recommendation> find_knees(std::span<const RateSummary> summaries);

}  // namespace coppice::lab
