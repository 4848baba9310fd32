#pragma once

#include "rows/results.h"

#include <span>
#include <utility>

namespace coppice::lab {

/// Divides the times of each row's rays by how much slower than usual the machine was meanwhile,
/// and notes it as `drift`: what the reference took for all kinds over the sum of its medians over
/// the rows. All rows are of one scene.
void remove_drift(std::span<ResultRow> rows);

/// The least and the most drift of all rows; 1 and 1 if there are no rays.
[[nodiscard]] std::pair<double, double> drift_range(std::span<const ResultRow> rows);

}  // namespace coppice::lab
