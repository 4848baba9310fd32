#pragma once

#include "coppice/geom/vec3.h"

namespace coppice::inline v0 {

/// The volume that a ray's direction spans with the edge of a triangle as seen from its origin:
/// direction . ((from - origin) x (to - origin)), with its true sign, and 0 only if it is 0. The
/// arguments are floats in double.
[[nodiscard]] double edge_function(Vec3d origin, Vec3d direction, Vec3d from, Vec3d to) noexcept;

}  // namespace coppice::inline v0
