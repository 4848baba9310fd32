#pragma once

#include "coppice/geom/vec3.h"

namespace coppice::inline v0 {

/// What a query near a point does for a point that is not finite, or a distance that is negative
/// or NaN: nothing.
[[nodiscard]] inline bool is_searchable(Vec3f point, float max_distance) noexcept {
    return is_finite(point) && max_distance >= 0.0F;
}

/// The square of a distance, exact; infinite stays so.
[[nodiscard]] inline double squared(float distance) noexcept {
    return static_cast<double>(distance) * static_cast<double>(distance);
}

}  // namespace coppice::inline v0
