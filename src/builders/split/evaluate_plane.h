#pragma once

#include "coppice/builders/split_finder.h"

#include "builders/kernels/plane_costs.h"
#include "cost/split_cost.h"

namespace coppice::inline v0 {

/// The weights of a node's PrimRefs below, above and in a plane. PrimRefs across it count on both
/// sides. Sums of weights are exact.
struct SplitCounts {
    double below = 0.0;
    double above = 0.0;
    double in_plane = 0.0;
};

/// Evaluates the costs of planes perpendicular to one axis of one node. The children's areas are
/// linear in the position.
class PlaneEvaluator {
public:
    PlaneEvaluator(const Aabb& box, Axis axis, const SahCostModel& cost) noexcept
        : PlaneEvaluator(box, axis, cost, 1.0 / box.surface_area()) {}

    /// As above, with the inverse of the box's area already computed.
    PlaneEvaluator(const Aabb& box, Axis axis, const SahCostModel& cost,
                   double inverse_area) noexcept
        : axis_(axis),
          lower_(box.lower[axis]),
          upper_(box.upper[axis]),
          custom_(cost.custom.get()) {
        const double width = box.extent(next_axis(axis));
        const double height = box.extent(next_axis(next_axis(axis)));
        terms_ = {lower_,
                  upper_,
                  2.0 * width * height,
                  2.0 * (width + height),
                  inverse_area,
                  cost.traversal,
                  cost.intersection,
                  cost.intersection * (1.0 - cost.empty_bonus)};
    }

    /// The split at a position. PrimRefs in the plane go to the cheaper side, below if both cost
    /// the same.
    [[nodiscard]] SplitCandidate evaluate(float position,
                                          const SplitCounts& counts) const noexcept {
        const double at = position;
        const auto share_of = [&](double length) {
            return sah::scalar::area_share(terms_.cap_area, terms_.side_perimeter, length,
                                           terms_.inverse_area);
        };
        const double p_below = share_of(at - terms_.lower);
        const double p_above = share_of(terms_.upper - at);
        const SplitPlane plane{axis_, position};
        const double cost_if_below =
            cost_of(p_below, counts.below + counts.in_plane, p_above, counts.above);
        if (counts.in_plane == 0.0) return {plane, PlanarSide::below, cost_if_below};
        const double cost_if_above =
            cost_of(p_below, counts.below, p_above, counts.above + counts.in_plane);
        return cost_if_above < cost_if_below
                   ? SplitCandidate{plane, PlanarSide::above, cost_if_above}
                   : SplitCandidate{plane, PlanarSide::below, cost_if_below};
    }

    /// True for positions strictly inside the box, where a split is allowed.
    [[nodiscard]] bool is_inside(float position) const noexcept {
        return (position > lower_) & (position < upper_);  // unpredictable, so without a branch
    }

    /// The terms that evaluate() computes with, for kernels. Not valid for custom cost models.
    [[nodiscard]] const CostTerms& terms() const noexcept { return terms_; }

private:
    // Equals SahCostModel::split_cost() to the bit.
    [[nodiscard]] double cost_of(double p_below, double count_below, double p_above,
                                 double count_above) const noexcept {
        if (custom_ != nullptr) {
            return custom_->split_cost(p_below, count_below, p_above, count_above);
        }
        const bool cuts_off_empty_space = count_below == 0.0 || count_above == 0.0;
        const double intersection =
            cuts_off_empty_space ? terms_.empty_intersection : terms_.intersection;
        return sah::scalar::split_cost(terms_.traversal, intersection, p_below, count_below,
                                       p_above, count_above);
    }

    Axis axis_;
    float lower_;
    float upper_;
    const CostModel* custom_;  // null if the terms apply
    CostTerms terms_;
};

/// The split of a node at a given plane, which must be strictly inside its box. O(PrimRefs).
[[nodiscard]] SplitCandidate evaluate_plane(const SplitQuery& query, SplitPlane plane) noexcept;

}  // namespace coppice::inline v0
