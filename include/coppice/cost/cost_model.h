#pragma once

namespace coppice::inline v0 {

/// A cost model of your own, for SahCostModel::custom: what the parts of a tree cost a ray, in any
/// one unit. Called from several threads at once.
///
/// k-d trees are built with it: split rules evaluate planes with split_cost(), and a node becomes a
/// leaf by leaf_cost(). Small nodes are then searched by sorting instead of by vectors of planes.
/// measure() applies it to both kinds of trees. 8-wide trees are built with fixed cost constants.
class CostModel {
public:
    CostModel() = default;
    CostModel(const CostModel&) = delete;
    CostModel& operator=(const CostModel&) = delete;
    virtual ~CostModel() = default;

    /// The cost of one inner node; >= 0.
    [[nodiscard]] virtual double traversal_cost() const noexcept = 0;

    /// The cost of a leaf of `count` primitives (in an 8-wide tree: of blocks of eight) for a ray
    /// that meets it. Must be >= 0 and must not fall as `count` grows. `count` is not a whole
    /// number if sampled primitives count as several (SampleWeighting::expected).
    [[nodiscard]] virtual double leaf_cost(double count) const noexcept = 0;

    /// The expected cost of a split for a ray that meets the node, if both children were leaves.
    /// `p_below` and `p_above` are the children's surface areas divided by the node's. By default
    /// the sum of traversal_cost() and both leaf costs, weighted by these.
    [[nodiscard]] virtual double split_cost(double p_below, double count_below, double p_above,
                                            double count_above) const noexcept {
        return traversal_cost() + p_below * leaf_cost(count_below) +
               p_above * leaf_cost(count_above);
    }
};

}  // namespace coppice::inline v0
