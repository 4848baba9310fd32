#pragma once

#include "coppice/geom/closest_point.h"

#include <cmath>
#include <cstdint>
#include <limits>

namespace coppice::inline v0 {

/// A point of a cloud near a query point. A default-constructed Neighbor has infinite distance and
/// stands for no point. Results are ordered by distance, equally near ones by id.
struct Neighbor {
    double distance_squared = std::numeric_limits<double>::infinity();  ///< infinite: none found
    std::uint32_t prim = 0;                                             ///< id of the primitive

    /// The distance; infinite if nothing was found.
    [[nodiscard]] double distance() const noexcept { return std::sqrt(distance_squared); }

    /// True if it stands for a primitive.
    [[nodiscard]] bool is_found() const noexcept {
        return distance_squared < std::numeric_limits<double>::infinity();
    }
};

/// The point of a triangle nearest to a query point: the Neighbor of a mesh.
struct SurfaceNeighbor {
    double distance_squared = std::numeric_limits<double>::infinity();  ///< infinite: none found
    Vec3f point;             ///< the closest point of the triangle
    float u = 0.0F;          ///< barycentric coordinate of the triangle's second corner
    float v = 0.0F;          ///< barycentric coordinate of the third corner
    std::uint32_t prim = 0;  ///< id of the primitive
    TriangleFeature feature = TriangleFeature::face;  ///< feature that the point lies on

    /// The distance; infinite if nothing was found.
    [[nodiscard]] double distance() const noexcept { return std::sqrt(distance_squared); }

    /// True if it stands for a primitive.
    [[nodiscard]] bool is_found() const noexcept {
        return distance_squared < std::numeric_limits<double>::infinity();
    }
};

}  // namespace coppice::inline v0
