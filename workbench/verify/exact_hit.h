#pragma once

#include "coppice/geom/ray.h"
#include "coppice/geom/triangle.h"

#include <optional>

namespace coppice::lab {

/// Where a ray's line meets a triangle, both sides, edges and corners included, decided by rational
/// arithmetic: nothing is rounded but the result. The ray must be traceable; its limits are
/// ignored. A line in the triangle's plane does not meet it, and nothing meets one without area.
[[nodiscard]] std::optional<double> exact_distance(const Ray& ray, const Triangle& triangle);

/// False only if exact_distance() finds nothing: the same by double, with a bound on its rounding.
[[nodiscard]] bool may_meet(const Ray& ray, const Triangle& triangle) noexcept;

}  // namespace coppice::lab
