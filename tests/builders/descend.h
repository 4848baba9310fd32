// A walk that takes the PrimRefs of every node along.
#pragma once

#include "coppice/tree/kd_tree.h"
#include "coppice/tree/walk.h"

#include "builders/kd/partition.h"

#include <utility>
#include <vector>

namespace coppice::test {

/// Calls `visit(const VisitedNode&, const std::vector<PrimRef>&)` for all nodes of a tree, with
/// the PrimRefs of `from` that come down to each.
template <typename Visit>
void descend(const KdTree& tree, PrimitiveSetView primitives, Clipping clipping,
             const VisitedNode& at, std::vector<PrimRef> prim_refs, Visit& visit) {
    visit(at, std::as_const(prim_refs));
    const KdNode& node = tree.nodes()[at.index];
    if (node.is_leaf()) return;
    Partition sides =
        partition(prim_refs, node.plane(), node.planar_side(), {primitives, clipping});
    descend(tree, primitives, clipping,
            {node.lower_child(), below(at.box, node.plane()), at.depth + 1}, std::move(sides.below),
            visit);
    descend(tree, primitives, clipping,
            {node.upper_child(), above(at.box, node.plane()), at.depth + 1}, std::move(sides.above),
            visit);
}

/// descend() from the root with all primitives.
template <typename Visit>
void descend(const KdTree& tree, PrimitiveSetView primitives, Clipping clipping, Visit&& visit) {
    descend(tree, primitives, clipping, {0, tree.bounds(), 0}, whole_prim_refs(primitives), visit);
}

}  // namespace coppice::test
