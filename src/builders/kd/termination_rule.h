#pragma once

#include "coppice/builders/kd_options.h"
#include "coppice/builders/split_finder.h"

#include <cstdint>
#include <limits>

namespace coppice::inline v0 {

/// How long split rules look for a plane.
enum class SplitSearch {
    first_offer,   ///< the first axis that offers a plane decides, as in the thesis
    until_it_pays  ///< on through all axes until a split costs less than the leaf
};

/// What the way down has made of a node, beside its PrimRefs.
struct NodeState {
    Aabb box;
    int depth = 0;
    int bad_refines_so_far = 0;
    double duplication = 1.0;  ///< how many a PrimRef has become on the path, on average

    /// The state of a child with this box. `more`: the PrimRefs of both children over the node's.
    [[nodiscard]] NodeState child(const Aabb& child_box, double more) const noexcept {
        return {child_box, depth + 1, bad_refines_so_far, duplication * more};
    }
};

/// When a node is not split any further.
struct TerminationRule {
    std::uint32_t max_leaf;  ///< nodes of at most that weight are leaves; 0: only empty ones
    int bad_refines;         ///< as in SplitOptions; 1: no split that does not pay
    int max_depth;
    SplitSearch search;
    double max_duplication;  ///< as in SplitOptions; along each path, so that it holds whatever the
                             ///< order in which nodes are built

    /// True if a node is a leaf whatever split there might be. `weight`: of its PrimRefs.
    [[nodiscard]] bool ends_at(const NodeState& node, double weight,
                               const SahCostModel& cost) const noexcept {
        if (weight == 0.0 || weight <= max_leaf || node.depth >= max_depth) return true;
        if (node.box.surface_area() == 0.0) return true;
        if (search == SplitSearch::first_offer) return false;
        // No split costs less than passing a node.
        return cost.leaf_cost(weight) <= cost.traversal_cost() ||
               node.duplication > max_duplication;
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

/// Splits go on as long as they pay.
[[nodiscard]] inline TerminationRule until_it_pays(const SplitOptions& split) noexcept {
    return {split.min_split - 1, 1, split.max_depth, SplitSearch::until_it_pays,
            static_cast<double>(split.max_duplication)};
}

}  // namespace coppice::inline v0
