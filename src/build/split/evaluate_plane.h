#pragma once

#include "coppice/build/split_finder.h"

#include <cstdint>

namespace coppice {

/// The weight of a node's fragments on either side of a plane and in it. Those across it count on
/// both sides. Sums of weights are exact.
struct SplitCounts {
    double below = 0.0;
    double above = 0.0;
    double in_plane = 0.0;
};

/// Costs of planes perpendicular to one axis of one node; the areas are linear in the position.
class PlaneEvaluator {
public:
    PlaneEvaluator(const Aabb& box, Axis axis, const SahCostModel& cost) noexcept;

    /// The split at a position, with the fragments in the plane on the cheaper side; below if
    /// equal.
    [[nodiscard]] Split evaluate(float position, const SplitCounts& counts) const noexcept;

    /// True for positions strictly inside the box: all that may be split at.
    [[nodiscard]] bool is_inside(float position) const noexcept {
        return position > lower_ && position < upper_;
    }

private:
    Axis axis_;
    float lower_;
    float upper_;
    double cap_area_;        // both faces perpendicular to the axis
    double side_perimeter_;  // area of the other four faces per unit of length
    double inverse_area_;
    const SahCostModel& cost_;
};

/// The split of a node at a given plane, strictly inside its box; O(fragments).
[[nodiscard]] Split evaluate_plane(const SplitQuery& query, Plane plane) noexcept;

}  // namespace coppice
