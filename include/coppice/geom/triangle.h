#pragma once

#include "coppice/export.h"
#include "coppice/geom/aabb.h"
#include "coppice/geom/ray.h"
#include "coppice/geom/vec3.h"

#include <array>
#include <cstddef>
#include <optional>

namespace coppice::inline v0 {

/// Three corners in space.
using Triangle = std::array<Vec3f, 3>;

/// The box of a triangle's corners.
[[nodiscard]] COPPICE_EXPORT Aabb triangle_bounds(const Triangle& triangle) noexcept;

/// The same, but all NaN if any coordinate is, which a box of the other corners would hide.
[[nodiscard]] COPPICE_EXPORT Aabb triangle_bounds_or_nan(const Triangle& triangle) noexcept;

/// Area, in double precision; 0 for a degenerate triangle.
[[nodiscard]] COPPICE_EXPORT double triangle_area(const Triangle& triangle) noexcept;

/// The box of the part of a triangle that lies in `box`; empty if no part does. Conservative: a
/// triangle that comes within one float ulp of the box counts as touching it, bounds are rounded
/// outward, and the result never leaves `box`.
/// Source: [WaldHavran2006] sec. 2.4 (perfect splits), [SutherlandHodgman1974].
[[nodiscard]] COPPICE_EXPORT Aabb clipped_triangle_bounds(const Triangle& triangle,
                                                          const Aabb& box) noexcept;

struct FrameExtent;

/// A traceable ray made ready to be tested against many triangles, both sides, edges and corners
/// included. What is hit is decided as by exact arithmetic, so two triangles that share an edge
/// leave no gap between them; a triangle is not hit by a ray in its plane.
/// Source: [Woop2013], evaluated in double precision and, where that leaves it open, without
/// rounding.
class COPPICE_EXPORT TriangleTest {
public:
    /// The ray must be one that is_traceable(); its t_max is ignored.
    explicit TriangleTest(const Ray& ray) noexcept;

    /// The hit with one triangle at a t of at most `t_max`. Its `prim` is 0.
    [[nodiscard]] std::optional<Hit> operator()(const Triangle& triangle,
                                                float t_max) const noexcept;

private:
    using Corners = std::array<Vec3d, 3>;
    using Weights = std::array<double, 3>;

    [[nodiscard]] Vec3d to_frame(Vec3f corner) const noexcept;
    [[nodiscard]] Weights precise_weights(const Triangle& triangle) const noexcept;
    [[nodiscard]] double distance(const Corners& corner, const Weights& weight, FrameExtent extent,
                                  const Triangle& triangle) const noexcept;

    Vec3d origin_;
    Vec3d direction_;
    float t_min_;
    RayAxes axes_;
    double shear_x_;
    double shear_y_;
    double scale_z_;
};

/// The hit of a ray with one triangle, both sides, edges and corners included, as TriangleTest
/// finds it. A ray that is not traceable hits nothing. The returned `prim` is 0.
[[nodiscard]] COPPICE_EXPORT std::optional<Hit> intersect_triangle(
    const Ray& ray, const Triangle& triangle) noexcept;

}  // namespace coppice::inline v0
