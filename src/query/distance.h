#pragma once

#include "coppice/geom/vec3.h"

namespace coppice::inline v0 {

/// The squared distance of two points, the same to the bit wherever it is computed. Monotonic: if
/// the difference on an axis grows, the result does not shrink, whatever the rounding.
[[nodiscard]] inline double distance_squared(Vec3f a, Vec3f b) noexcept {
    const Vec3d between = to_double(a) - to_double(b);
    return dot(between, between);
}

}  // namespace coppice::inline v0
