#pragma once

#include "coppice/export.h"
#include "coppice/geom/triangle.h"

#include <cstdint>

namespace coppice::inline v0 {

/// The feature of a triangle that a point lies on. Edge i runs from corner i to corner i + 1.
enum class TriangleFeature : std::uint8_t {
    face,
    edge_0,
    edge_1,
    edge_2,
    corner_0,
    corner_1,
    corner_2
};

/// The point of a triangle that is closest to a query point.
struct ClosestPoint {
    double distance_squared = 0.0;  ///< squared distance between the two points
    Vec3f point;                    ///< the closest point, rounded to float
    float u = 0.0F;                 ///< barycentric coordinate of the second corner, in [0, 1]
    float v = 0.0F;                 ///< barycentric coordinate of the third corner, in [0, 1]
    TriangleFeature feature = TriangleFeature::face;  ///< feature that the point lies on
};

/// Returns the point of `triangle` that is closest to `to`, computed in double precision. No
/// coordinate may be NaN or infinite. Two triangles that share an edge or a corner have equal
/// squared distances, to the bit, to every point that is closest to that edge or corner. A triangle
/// without area is treated as the segment or point that it is.
[[nodiscard]] COPPICE_EXPORT ClosestPoint closest_point(const Triangle& triangle,
                                                        Vec3f to) noexcept;

}  // namespace coppice::inline v0
