#pragma once

#include "coppice/builders/split_finder.h"

#include "builders/kernels/plane_costs.h"
#include "cost/split_cost.h"

namespace coppice::inline v0 {

/// The weight of a node's PrimRefs on either side of a plane and in it. Those across it count on
/// both sides. Sums of weights are exact.
struct SplitCounts {
    double below = 0.0;
    double above = 0.0;
    double in_plane = 0.0;
};

/// Costs of planes perpendicular to one axis of one node; the areas are linear in the position.
class PlaneEvaluator {
public:
    PlaneEvaluator(const Aabb& box, Axis axis, const SahCostModel& cost) noexcept
        : PlaneEvaluator(box, axis, cost, 1.0 / box.surface_area()) {}

    /// The same with the inverse of the box's area known.
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

    /// The split at a position, with the PrimRefs in the plane on the cheaper side; below if
    /// equal.
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

    /// True for positions strictly inside the box: all that may be split at.
    [[nodiscard]] bool is_inside(float position) const noexcept {
        return (position > lower_) & (position < upper_);  // mostly unpredictable: no branch
    }

    /// What evaluate() computes with, for kernels; not where the cost model is a custom one.
    [[nodiscard]] const CostTerms& terms() const noexcept { return terms_; }

private:
    // SahCostModel::split_cost(), bit for bit.
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
    const CostModel* custom_;  // null: by the terms
    CostTerms terms_;
};

/// The split of a node at a given plane, strictly inside its box; O(PrimRefs).
[[nodiscard]] SplitCandidate evaluate_plane(const SplitQuery& query, SplitPlane plane) noexcept;

}  // namespace coppice::inline v0
