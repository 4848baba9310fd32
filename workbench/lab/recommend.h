#pragma once

#include "lab/results.h"

#include <span>
#include <vector>

namespace coppice::lab {

/// The chosen percentage of each kind of primitive and protocol among the rows of one scene: the
/// knee (find_knee()) of the curve of cost against total time, both relative to the 100 % tree and
/// averaged over the seeds. In the order of the rows.
[[nodiscard]] std::vector<Recommendation> recommend(std::span<const ResultRow> rows);

}  // namespace coppice::lab
