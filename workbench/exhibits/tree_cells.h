#pragma once

#include "coppice/cost/sah_cost_model.h"
#include "coppice/tree/kd_tree.h"

#include "report/exhibits.h"

#include <cstddef>
#include <vector>

namespace coppice::lab {

/// The nodes of a tree as boxes, level by level, with what they cost by `model` and hold. Of levels
/// with more than `most_shown` nodes (> 0) as many are given, evenly spread in depth-first order.
[[nodiscard]] std::vector<report::CellLevel> collect_cells(const KdTree& tree,
                                                           const SahCostModel& model,
                                                           std::size_t most_shown);

}  // namespace coppice::lab
