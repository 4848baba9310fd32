// A sound tree small enough to break by hand.
#pragma once

#include "coppice/tree/kd_tree.h"

#include "support/sphere_set.h"

#include <cstdint>
#include <vector>

namespace coppice::test {

/// The arrays of a tree, to be altered before they become one.
struct TreeParts {
    std::vector<KdNode> nodes;
    std::vector<std::uint32_t> references;
    Aabb bounds;

    [[nodiscard]] KdTree tree() const { return {nodes, references, bounds}; }
};

[[nodiscard]] inline KdNode inner_node(Axis axis, float position, std::uint32_t lower_child) {
    return KdNode::make_inner({axis, position}, PlanarSide::below, lower_child);
}

/// The unit box whose lower corner is (x, 0, 0).
[[nodiscard]] inline Aabb box_at(float x, float width = 1.0F) {
    return {{x, 0, 0}, {x + width, 1, 1}};
}

/// Boxes at x = 0, 2, 4, 6 of width 1, and one that reaches from 0.5 to 2.5.
[[nodiscard]] inline BoxSet five_boxes() {
    return BoxSet({box_at(0), box_at(2), box_at(4), box_at(6), box_at(0.5F, 2)});
}

/// A sound tree over five_boxes() with four leaves: {0, 4}, {1, 4}, {2}, {3}.
[[nodiscard]] inline TreeParts parts_over_five_boxes() {
    return {{inner_node(Axis::x, 3.5F, 1), inner_node(Axis::x, 1.5F, 3),
             inner_node(Axis::x, 5.5F, 5), KdNode::make_leaf(0, 2), KdNode::make_leaf(2, 2),
             KdNode::make_leaf(4, 1), KdNode::make_leaf(5, 1)},
            {0, 4, 1, 4, 2, 3},
            {{0, 0, 0}, {7, 1, 1}}};
}

}  // namespace coppice::test
