#pragma once

#include "coppice/geom/vec3.h"

namespace coppice::inline v0 {

/// The square of the distance of two points, the same to the bit wherever it is computed: of
/// differences that grow it grows, too, whatever the rounding.
[[nodiscard]] inline double distance_squared(Vec3f a, Vec3f b) noexcept {
    const Vec3d between = to_double(a) - to_double(b);
    return dot(between, between);
}

}  // namespace coppice::inline v0
