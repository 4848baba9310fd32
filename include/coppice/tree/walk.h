#pragma once

#include "coppice/geom/aabb.h"
#include "coppice/tree/kd_tree.h"

#include <cstdint>
#include <span>

namespace coppice::inline v0 {

/// A node met on a walk: its index, its box and its depth (the root's is 0).
struct VisitedNode {
    std::uint32_t index = 0;  ///< into the nodes of the tree
    Aabb box;                 ///< that the planes above leave to it
    int depth = 0;            ///< 0 for the root
};

/// Calls `visit(const VisitedNode&)` for a node and all below it, depth first, parents before
/// children, lower children before upper ones. Recursion depth is the tree's depth.
template <typename Visit>
void walk_below(std::span<const KdNode> nodes, const VisitedNode& at, Visit&& visit) {
    visit(at);
    const KdNode& node = nodes[at.index];
    if (node.is_leaf()) return;
    const SplitPlane plane = node.plane();
    walk_below(nodes, {node.lower_child(), below(at.box, plane), at.depth + 1}, visit);
    walk_below(nodes, {node.upper_child(), above(at.box, plane), at.depth + 1}, visit);
}

/// walk_below() from the root of a tree.
template <typename Visit>
void walk(const KdTree& tree, Visit&& visit) {
    walk_below(tree.nodes(), {0, tree.bounds(), 0}, visit);
}

}  // namespace coppice::inline v0
