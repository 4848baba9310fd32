#pragma once

namespace coppice::inline v0 {

/// A cost model of one's own, for SahCostModel::custom: what the parts of a tree cost a ray, in one
/// unit of your choice. Called from several threads at once.
///
/// k-d trees are built by it: rules evaluate their planes by split_cost(), a node becomes a leaf by
/// leaf_cost(). Small nodes are then searched by sorting, not by vectors of planes. measure()
/// applies it to both kinds of trees; 8-wide trees are built by constants of their own.
class CostModel {
public:
    CostModel() = default;
    CostModel(const CostModel&) = delete;
    CostModel& operator=(const CostModel&) = delete;
    virtual ~CostModel() = default;

    /// Of passing one inner node; >= 0.
    [[nodiscard]] virtual double traversal_cost() const noexcept = 0;

    /// Of a leaf of `count` primitives (of an 8-wide tree: blocks of eight) once a ray is in it;
    /// >= 0, and no less for more of them. `count` is no whole number where sampled primitives
    /// count what they stand for.
    [[nodiscard]] virtual double leaf_cost(double count) const noexcept = 0;

    /// Of a split for a ray in the node, if both children were leaves. `p_below`, `p_above`: the
    /// children's surface areas over the node's. By itself that of the children weighted by these.
    [[nodiscard]] virtual double split_cost(double p_below, double count_below, double p_above,
                                            double count_above) const noexcept {
        return traversal_cost() + p_below * leaf_cost(count_below) +
               p_above * leaf_cost(count_above);
    }
};

}  // namespace coppice::inline v0
