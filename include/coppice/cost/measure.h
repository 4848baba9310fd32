#pragma once

#include "coppice/cost/sah_cost_model.h"
#include "coppice/cost/tree_statistics.h"
#include "coppice/export.h"
#include "coppice/tree/bvh8.h"
#include "coppice/tree/kd_tree.h"

namespace coppice::inline v0 {

/// Counts the nodes and references of a tree and computes its cost bottom-up: C(leaf) = t_isect n,
/// C(inner) = t_trav + SA(below)/SA C(below) + SA(above)/SA C(above). Children of a node without
/// area (a line or a point) add no cost, because no ray meets them.
/// Source: [Tsiompikas2022] eq. 4 to 6.
[[nodiscard]] COPPICE_EXPORT TreeStatistics measure(const KdTree& tree, const SahCostModel& model);

/// The statistics of an 8-wide tree. Its nodes are the inner nodes, its leaf slots the leaves, and
/// a reference is a triangle in a leaf. A block of eight triangles costs one intersection, because
/// its triangles are tested together.
[[nodiscard]] COPPICE_EXPORT TreeStatistics measure(const Bvh8& tree, const SahCostModel& model);

}  // namespace coppice::inline v0
