#pragma once

#include "coppice/geom/vec3.h"

namespace coppice::inline v0 {

/// The edge function: direction . ((from - origin) x (to - origin)), the volume spanned by the
/// ray's direction and the edge as seen from the ray's origin. The sign is exact, and the result is
/// 0 only if the exact value is 0. All arguments must be floats stored as doubles.
[[nodiscard]] double edge_function(Vec3d origin, Vec3d direction, Vec3d from, Vec3d to) noexcept;

}  // namespace coppice::inline v0
