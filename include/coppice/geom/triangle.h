#pragma once

#include "coppice/geom/aabb.h"
#include "coppice/geom/ray.h"
#include "coppice/geom/vec3.h"

#include <array>
#include <optional>

namespace coppice {

/// Three corners in space.
using Triangle = std::array<Vec3f, 3>;

/// The box of a triangle's corners.
[[nodiscard]] Aabb triangle_bounds(const Triangle& triangle) noexcept;

/// Area, in double precision; 0 for a degenerate triangle.
[[nodiscard]] double triangle_area(const Triangle& triangle) noexcept;

/// The box of the part of a triangle that lies in `box`; empty if no part does. Conservative: a
/// triangle that comes within one float ulp of the box counts as touching it, bounds are rounded
/// outward, and the result never leaves `box`.
/// Source: [WaldHavran2006] sec. 2.4 (perfect splits), [SutherlandHodgman1974].
[[nodiscard]] Aabb clipped_triangle_bounds(const Triangle& triangle, const Aabb& box) noexcept;

/// The hit of a ray with one triangle, both sides, edges and corners included. Watertight: two
/// triangles that share an edge leave no gap between them. The returned `prim` is 0.
/// Source: [Woop2013], evaluated in double precision.
[[nodiscard]] std::optional<Hit> intersect_triangle(const Ray& ray,
                                                    const Triangle& triangle) noexcept;

}  // namespace coppice
