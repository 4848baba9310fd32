#pragma once

#include "coppice/builders/kd_options.h"
#include "coppice/builders/split_finder.h"

#include <cstdint>
#include <limits>

namespace coppice::inline v0 {

/// How long a split rule searches.
enum class SplitSearch {
    first_offer,   ///< up to the first axis that has a plane, as in the thesis
    until_it_pays  ///< through all axes, until a split costs less than the leaf
};

/// The state of a node besides its PrimRefs, accumulated along its path.
struct NodeState {
    Aabb box;
    int depth = 0;
    int bad_refines_so_far = 0;
    double duplication = 1.0;  ///< average number of PrimRefs per PrimRef of the root

    /// The state of a child with this box. `more` is the number of PrimRefs of both children
    /// divided by that of the node.
    [[nodiscard]] NodeState child(const Aabb& child_box, double more) const noexcept {
        return {child_box, depth + 1, bad_refines_so_far, duplication * more};
    }
};

/// The conditions that end splitting.
struct TerminationRule {
    std::uint32_t max_leaf;  ///< nodes of at most this weight are leaves; 0: only empty ones
    int bad_refines;         ///< as in SplitOptions; 1: every split must pay
    int max_depth;
    SplitSearch search;
    double max_duplication;  ///< as in SplitOptions; applied to each path, so that the tree does
                             ///< not depend on the order in which nodes are built

    /// True if a node becomes a leaf without a search for a split. `weight` is the sum of its
    /// PrimRefs' weights.
    [[nodiscard]] bool ends_at(const NodeState& node, double weight,
                               const SahCostModel& cost) const noexcept {
        if (weight == 0.0 || weight <= max_leaf || node.depth >= max_depth) return true;
        if (node.box.surface_area() == 0.0) return true;
        if (search == SplitSearch::first_offer) return false;
        // No split costs less than the traversal of a node.
        return cost.leaf_cost(weight) <= cost.traversal_cost() ||
               node.duplication > max_duplication;
    }

    /// The cost below which a rule may stop searching.
    [[nodiscard]] double acceptable_cost(double leaf_cost) const noexcept {
        return search == SplitSearch::until_it_pays ? leaf_cost
                                                    : std::numeric_limits<double>::infinity();
    }

    /// True if a node is split at this cost. Counts a split that does not pay in `node`.
    [[nodiscard]] bool accepts(double split_cost, double leaf_cost,
                               NodeState& node) const noexcept {
        if (!(split_cost < leaf_cost)) ++node.bad_refines_so_far;
        return node.bad_refines_so_far < bad_refines;
    }
};

/// The rule that splits as long as a split pays.
[[nodiscard]] inline TerminationRule until_it_pays(const SplitOptions& split) noexcept {
    return {split.min_split - 1, 1, split.max_depth, SplitSearch::until_it_pays,
            static_cast<double>(split.max_duplication)};
}

}  // namespace coppice::inline v0
