#pragma once

#include "coppice/cost/sah_cost_model.h"
#include "coppice/cost/tree_statistics.h"
#include "coppice/export.h"
#include "coppice/tree/bvh8.h"
#include "coppice/tree/kd_tree.h"

namespace coppice::inline v0 {

/// Counts a tree and computes its cost bottom-up: C(leaf) = t_isect n, C(inner) = t_trav +
/// SA(below)/SA C(below) + SA(above)/SA C(above). Children of a node without area (a line, a
/// point) count nothing: no ray meets them. Source: [Tsiompikas2022] eq. 4 to 6.
[[nodiscard]] COPPICE_EXPORT TreeStatistics measure(const KdTree& tree, const SahCostModel& model);

/// The same of an 8-wide tree: nodes of eight as inner nodes, leaf slots as leaves, and a block of
/// eight triangles as what costs one intersection, for that is how they are tested. A reference is
/// a triangle in a leaf.
[[nodiscard]] COPPICE_EXPORT TreeStatistics measure(const Bvh8& tree, const SahCostModel& model);

}  // namespace coppice::inline v0
