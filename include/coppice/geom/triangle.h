#pragma once

#include "coppice/geom/aabb.h"
#include "coppice/geom/ray.h"
#include "coppice/geom/vec3.h"

#include <array>
#include <cstddef>
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

/// A traceable ray made ready to be tested against many triangles, both sides, edges and corners
/// included. Watertight: two triangles that share an edge leave no gap between them.
/// Source: [Woop2013], evaluated in double precision.
class TriangleTest {
public:
    /// The ray must be one that is_traceable(); its t_max is ignored.
    explicit TriangleTest(const Ray& ray) noexcept;

    /// The hit with one triangle at a t of at most `t_max`. Its `prim` is 0.
    [[nodiscard]] std::optional<Hit> operator()(const Triangle& triangle,
                                                float t_max) const noexcept;

private:
    [[nodiscard]] Vec3d to_frame(Vec3f corner) const noexcept;

    Vec3d origin_;
    float t_min_;
    RayAxes axes_;
    double shear_x_;
    double shear_y_;
    double scale_z_;
};

/// The hit of a ray with one triangle, both sides, edges and corners included, as TriangleTest
/// finds it. A ray that is not traceable hits nothing. The returned `prim` is 0.
[[nodiscard]] std::optional<Hit> intersect_triangle(const Ray& ray,
                                                    const Triangle& triangle) noexcept;

}  // namespace coppice
