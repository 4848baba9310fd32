#pragma once

#include "coppice/geom/vec3.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>

namespace coppice::inline v0 {

/// The points origin + t * direction with t in [t_min, t_max]. The direction need not have unit
/// length; t is measured in multiples of it.
struct Ray {
    Vec3f origin;                                          ///< where t is 0
    Vec3f direction;                                       ///< not zero
    float t_min = 0.0F;                                    ///< nothing is hit before it
    float t_max = std::numeric_limits<float>::infinity();  ///< nothing is hit behind it
};

/// True if a ray can hit anything: finite origin, finite direction other than zero, and
/// t_min <= t_max with t_max >= 0. All other rays hit nothing.
[[nodiscard]] inline bool is_traceable(const Ray& ray) noexcept {
    return is_finite(ray.origin) && is_finite(ray.direction) && ray.direction != Vec3f{} &&
           ray.t_min <= ray.t_max && ray.t_max >= 0.0F;
}

/// The axes x, y, z as a ray sees them: that of its direction's longest component (the first of
/// equals) becomes z, the others follow in cyclic order.
struct RayAxes {
    // Without branches: of incoherent rays no processor can predict the longest component.
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
    std::size_t y;  ///< of the second
    std::size_t z;  ///< of the one along which the direction is longest
};

/// Where a ray meets a primitive; one with infinite t, as a default one has, is no hit. For
/// triangles (u, v) are the barycentric coordinates of the second and third vertex; `normal` is (b
/// - a) x (c - a), which points to the side from which the corners a, b, c are seen in
/// counter-clockwise order. Its length is twice the triangle's area: for edges above 1e19 it
/// overflows, for edges below 1e-22 it is 0.
struct Hit {
    float t = std::numeric_limits<float>::infinity();  ///< distance in multiples of the direction
    float u = 0.0F;                                    ///< weight of the second vertex
    float v = 0.0F;                                    ///< weight of the third
    std::uint32_t prim = 0;                            ///< id of the primitive
    Vec3f normal;                                      ///< of any length

    /// False for what batches write where a ray hits nothing.
    [[nodiscard]] bool is_hit() const noexcept {
        return t < std::numeric_limits<float>::infinity();
    }

    friend bool operator==(const Hit&, const Hit&) = default;
};

}  // namespace coppice::inline v0
