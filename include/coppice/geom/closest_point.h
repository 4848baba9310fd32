#pragma once

#include "coppice/export.h"
#include "coppice/geom/triangle.h"

#include <cstdint>

namespace coppice::inline v0 {

/// The part of a triangle that a point of it belongs to. Edge i runs from corner i to corner i + 1.
enum class TriangleFeature : std::uint8_t {
    face,
    edge_0,
    edge_1,
    edge_2,
    corner_0,
    corner_1,
    corner_2
};

/// The point of a triangle that is closest to another point.
struct ClosestPoint {
    double distance_squared = 0.0;  ///< between the two
    Vec3f point;                    ///< rounded to float
    float u = 0.0F;                 ///< barycentric coordinate of the second corner, in [0, 1]
    float v = 0.0F;                 ///< of the third
    TriangleFeature feature = TriangleFeature::face;  ///< what it lies on
};

/// The point of a triangle closest to `to`, in double precision; neither may be NaN or infinite.
/// Two triangles that share an edge or a corner to which a point is closest have the very same
/// squared distance to it. Triangles without area are the segments or points they are.
[[nodiscard]] COPPICE_EXPORT ClosestPoint closest_point(const Triangle& triangle,
                                                        Vec3f to) noexcept;

}  // namespace coppice::inline v0
