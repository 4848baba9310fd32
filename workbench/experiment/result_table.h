#pragma once

#include "rows/results.h"

#include <string>

namespace coppice::lab {

/// The results of a scene as plain text: one table for each kind of primitive with a block for
/// each protocol, rows averaged over the seeds with 95 % t intervals of relative cost and time,
/// then the recommended percentages, by this tolerance, and the knees.
[[nodiscard]] std::string result_table(const SceneResult& scene, double tolerance);

}  // namespace coppice::lab
