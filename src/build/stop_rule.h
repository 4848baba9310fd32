#pragma once

#include "coppice/build/build_options.h"
#include "coppice/build/split_finder.h"

#include <cstdint>
#include <limits>

namespace coppice {

/// How long split rules look for a plane.
enum class SplitSearch {
    first_offer,   ///< the first axis that offers a plane decides, as in the thesis
    until_it_pays  ///< on through all axes until a split costs less than the leaf
};

/// What the way down has made of a node, beside its fragments.
struct NodeState {
    Aabb box;
    int depth = 0;
    int bad_refines_so_far = 0;

    /// The state of a child with this box.
    [[nodiscard]] NodeState child(const Aabb& child_box) const noexcept {
        return {child_box, depth + 1, bad_refines_so_far};
    }
};

/// When a node is not split any further.
struct StopRule {
    std::uint32_t max_leaf;  ///< nodes of at most that weight are leaves; 0: only empty ones
    int bad_refines;         ///< as in SplitOptions; 1: no split that does not pay
    int max_depth;
    SplitSearch search;

    /// True if a node is a leaf whatever split there might be. `weight`: of its fragments.
    [[nodiscard]] bool ends_at(const NodeState& node, double weight,
                               const SahCostModel& cost) const noexcept {
        if (weight == 0.0 || weight <= max_leaf || node.depth >= max_depth) return true;
        if (node.box.surface_area() == 0.0) return true;
        // No split costs less than passing a node.
        return search == SplitSearch::until_it_pays && cost.leaf_cost(weight) <= cost.traversal;
    }

    /// The cost below which a rule need not look further.
    [[nodiscard]] double acceptable_cost(double leaf_cost) const noexcept {
        return search == SplitSearch::until_it_pays ? leaf_cost
                                                    : std::numeric_limits<double>::infinity();
    }

    /// True if a node is to be split at this cost; counts a bad refine on the node's path.
    [[nodiscard]] bool accepts(double split_cost, double leaf_cost,
                               NodeState& node) const noexcept {
        if (!(split_cost < leaf_cost)) ++node.bad_refines_so_far;
        return node.bad_refines_so_far < bad_refines;
    }
};

}  // namespace coppice
