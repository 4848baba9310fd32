#pragma once

#include "rows/results.h"

#include <cstddef>
#include <string>

namespace coppice::lab {

/// The rows of a scene from `first` on as plain text: one table for each kind of primitive with a
/// block for each builder and sampler, averaged over the seeds with 95 % t intervals of relative
/// cost and time. The rows before `first` are whole blocks, so that a table can be written while
/// its rows are measured.
[[nodiscard]] std::string result_rows(const SceneResult& scene, std::size_t first = 0);

/// What follows the rows of a scene: the recommended percentages, by this tolerance, and the knees.
/// Nothing if there are no rows.
[[nodiscard]] std::string result_choices(const SceneResult& scene, double tolerance);

}  // namespace coppice::lab
