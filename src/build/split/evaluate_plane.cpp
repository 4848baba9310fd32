#include "build/split/evaluate_plane.h"

#include "build/partition.h"

namespace coppice {

PlaneEvaluator::PlaneEvaluator(const Aabb& box, Axis axis, const SahCostModel& cost) noexcept
    : axis_(axis), lower_(box.lower[axis]), upper_(box.upper[axis]), cost_(cost) {
    const double width = box.extent(next_axis(axis));
    const double height = box.extent(next_axis(next_axis(axis)));
    cap_area_ = 2.0 * width * height;
    side_perimeter_ = 2.0 * (width + height);
    inverse_area_ = 1.0 / box.surface_area();
}

Split PlaneEvaluator::evaluate(float position, const SplitCounts& counts) const noexcept {
    const double at = position;
    const double p_below = (cap_area_ + side_perimeter_ * (at - lower_)) * inverse_area_;
    const double p_above = (cap_area_ + side_perimeter_ * (upper_ - at)) * inverse_area_;
    const auto cost_of = [&](double count_below, double count_above) {
        return cost_.split_cost(p_below, count_below, p_above, count_above);
    };
    const Plane plane{axis_, position};
    const double cost_if_below = cost_of(counts.below + counts.in_plane, counts.above);
    if (counts.in_plane == 0.0) return {plane, PlanarSide::below, cost_if_below};
    const double cost_if_above = cost_of(counts.below, counts.above + counts.in_plane);
    return cost_if_above < cost_if_below ? Split{plane, PlanarSide::above, cost_if_above}
                                         : Split{plane, PlanarSide::below, cost_if_below};
}

double weight_of(std::span<const Fragment> fragments) noexcept {
    double weight = 0.0;
    for (const Fragment& fragment : fragments)
        weight += fragment.weight;
    return weight;
}

Split evaluate_plane(const SplitQuery& query, Plane plane) noexcept {
    SplitCounts counts;
    for (const Fragment& fragment : query.fragments) {
        switch (relation_to(fragment.box, plane)) {
            case PlaneRelation::below:
                counts.below += fragment.weight;
                break;
            case PlaneRelation::above:
                counts.above += fragment.weight;
                break;
            case PlaneRelation::in_plane:
                counts.in_plane += fragment.weight;
                break;
            case PlaneRelation::across:
                counts.below += fragment.weight;
                counts.above += fragment.weight;
                break;
        }
    }
    return PlaneEvaluator(query.box, plane.axis, query.cost).evaluate(plane.position, counts);
}

}  // namespace coppice
