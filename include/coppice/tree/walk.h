#pragma once

#include "coppice/geom/aabb.h"
#include "coppice/tree/kd_tree.h"

#include <cstdint>
#include <span>

namespace coppice::inline v0 {

/// A node visited by walk(): its index, its box and its depth.
struct VisitedNode {
    std::uint32_t index = 0;  ///< index into the nodes of the tree
    Aabb box;                 ///< the node's cell
    int depth = 0;            ///< 0 for the root
};

/// Calls `visit(const VisitedNode&)` for node `at` and all nodes below it, depth first: parents
/// before children, lower children before upper ones. The recursion is as deep as the tree.
template <typename Visit>
void walk_below(std::span<const KdNode> nodes, const VisitedNode& at, Visit&& visit) {
    visit(at);
    const KdNode& node = nodes[at.index];
    if (node.is_leaf()) return;
    const SplitPlane plane = node.plane();
    walk_below(nodes, {node.lower_child(), below(at.box, plane), at.depth + 1}, visit);
    walk_below(nodes, {node.upper_child(), above(at.box, plane), at.depth + 1}, visit);
}

/// Calls `visit(const VisitedNode&)` for all nodes of a tree, in the order of walk_below().
template <typename Visit>
void walk(const KdTree& tree, Visit&& visit) {
    walk_below(tree.nodes(), {0, tree.bounds(), 0}, visit);
}

}  // namespace coppice::inline v0
