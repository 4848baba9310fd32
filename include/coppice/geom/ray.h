#pragma once

#include "coppice/geom/vec3.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>

namespace coppice::inline v0 {

/// A ray: the points origin + t * direction with t in [t_min, t_max]. The direction need not have
/// unit length; t is measured in multiples of its length.
struct Ray {
    Vec3f origin;                                          ///< the point at t = 0
    Vec3f direction;                                       ///< of any length but zero
    float t_min = 0.0F;                                    ///< hits at a smaller t do not count
    float t_max = std::numeric_limits<float>::infinity();  ///< hits at a greater t do not count
};

/// True if a ray can hit anything: its origin is finite, its direction is finite and not zero,
/// t_min <= t_max and t_max >= 0. All other rays hit nothing.
[[nodiscard]] inline bool is_traceable(const Ray& ray) noexcept {
    return is_finite(ray.origin) && is_finite(ray.direction) && ray.direction != Vec3f{} &&
           ray.t_min <= ray.t_max && ray.t_max >= 0.0F;
}

/// A permutation of the axes that suits a ray. The axis of the direction's longest component (the
/// first of equals) becomes z; the other two follow in cyclic order.
struct RayAxes {
    // Written without branches: the longest component of incoherent rays is unpredictable.
    /// The axes for rays of this direction.
    explicit RayAxes(Vec3f direction) noexcept {
        const float longer = std::max(std::abs(direction.x), std::abs(direction.y));
        const auto is_z = static_cast<std::size_t>(std::abs(direction.z) > longer);
        const auto is_y = static_cast<std::size_t>(std::abs(direction.y) > std::abs(direction.x));
        constexpr std::array<std::size_t, 5> cycle{0, 1, 2, 0, 1};
        z = 2 * is_z + (1 - is_z) * is_y;
        x = cycle[z + 1];
        y = cycle[z + 2];
    }

    std::size_t x;  ///< index of the first axis
    std::size_t y;  ///< index of the second axis
    std::size_t z;  ///< index of the axis of the longest component
};

/// A hit of a ray with a primitive. A default-constructed Hit has infinite t and stands for no hit.
/// For triangles, (u, v) are the barycentric coordinates of the second and third vertex, and
/// `normal` is (b - a) x (c - a). The normal points to the side from which the corners a, b, c
/// appear in counter-clockwise order. Its length is twice the area of the triangle; it overflows
/// for edges above 1e19 and is 0 for edges below 1e-22.
struct Hit {
    float t = std::numeric_limits<float>::infinity();  ///< distance in multiples of the direction
    float u = 0.0F;                                    ///< barycentric, of the second vertex
    float v = 0.0F;                                    ///< barycentric, of the third vertex
    std::uint32_t prim = 0;                            ///< id of the primitive
    Vec3f normal;                                      ///< geometric normal, not normalized

    /// True if this is a hit. Batched queries write a Hit that is none for each ray that hits
    /// nothing.
    [[nodiscard]] bool is_hit() const noexcept {
        return t < std::numeric_limits<float>::infinity();
    }

    friend bool operator==(const Hit&, const Hit&) = default;
};

}  // namespace coppice::inline v0
