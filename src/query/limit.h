#pragma once

#include "coppice/geom/vec3.h"

namespace coppice::inline v0 {

/// True if a query near a point can find anything: the point is finite, and the distance is neither
/// negative nor NaN. Other queries find nothing.
[[nodiscard]] inline bool is_searchable(Vec3f point, float max_distance) noexcept {
    return is_finite(point) && max_distance >= 0.0F;
}

/// The square of a distance, exact in double; infinite for an infinite distance.
[[nodiscard]] inline double squared(float distance) noexcept {
    return static_cast<double>(distance) * static_cast<double>(distance);
}

}  // namespace coppice::inline v0
