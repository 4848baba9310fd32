#pragma once

#include "coppice/export.h"
#include "coppice/geom/aabb.h"
#include "coppice/geom/ray.h"
#include "coppice/geom/vec3.h"

#include <array>
#include <cstddef>
#include <optional>

namespace coppice::inline v0 {

/// The three corners of a triangle.
using Triangle = std::array<Vec3f, 3>;

/// The box of a triangle's corners.
[[nodiscard]] COPPICE_EXPORT Aabb triangle_bounds(const Triangle& triangle) noexcept;

/// The bounding box of a triangle's corners, or a box of NaN if any coordinate is NaN.
/// triangle_bounds() would ignore such a corner.
[[nodiscard]] COPPICE_EXPORT Aabb triangle_bounds_or_nan(const Triangle& triangle) noexcept;

/// The area of a triangle in double precision; 0 if it is degenerate.
[[nodiscard]] COPPICE_EXPORT double triangle_area(const Triangle& triangle) noexcept;

/// The bounding box of the part of a triangle that lies in `box`; empty if no part does.
/// Conservative: a triangle within one float ulp of the box counts as touching it, and bounds are
/// rounded outward. The result never extends beyond `box`.
/// Source: [WaldHavran2006] sec. 2.4 (perfect splits), [SutherlandHodgman1974].
[[nodiscard]] COPPICE_EXPORT Aabb clipped_triangle_bounds(const Triangle& triangle,
                                                          const Aabb& box) noexcept;

struct FrameExtent;

/// A traceable ray, prepared for tests against many triangles. Both sides of a triangle, its edges
/// and its corners count as hit. Whether a triangle is hit is decided as if by exact arithmetic, so
/// that a ray cannot pass between two triangles that share an edge. A ray that lies in the plane of
/// a triangle does not hit it.
/// Source: [Woop2013], evaluated in double precision and, where that cannot decide, without
/// rounding.
class COPPICE_EXPORT TriangleTest {
public:
    /// Prepares a ray, for which is_traceable() must hold. The ray's t_max is ignored.
    explicit TriangleTest(const Ray& ray) noexcept;

    /// The hit of the ray with one triangle at a t of at most `t_max`, or nothing. The `prim` of
    /// the hit is 0.
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

/// The hit of a ray with one triangle, as TriangleTest finds it, or nothing. A ray that is not
/// traceable hits nothing. The `prim` of the hit is 0.
[[nodiscard]] COPPICE_EXPORT std::optional<Hit> intersect_triangle(
    const Ray& ray, const Triangle& triangle) noexcept;

}  // namespace coppice::inline v0
