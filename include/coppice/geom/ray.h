#pragma once

#include "coppice/geom/vec3.h"

#include <cmath>
#include <cstdint>
#include <limits>

namespace coppice {

/// The points origin + t * direction with t in [t_min, t_max]. The direction need not have unit
/// length; t is measured in multiples of it.
struct Ray {
    Vec3f origin;
    Vec3f direction;
    float t_min = 0.0F;
    float t_max = std::numeric_limits<float>::infinity();
};

/// True if a ray can hit anything: finite origin, finite direction other than zero, and
/// t_min <= t_max with t_max >= 0. All other rays hit nothing.
[[nodiscard]] inline bool is_traceable(const Ray& ray) noexcept {
    const auto is_finite = [](Vec3f v) {
        return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
    };
    return is_finite(ray.origin) && is_finite(ray.direction) && ray.direction != Vec3f{} &&
           ray.t_min <= ray.t_max && ray.t_max >= 0.0F;
}

/// Where a ray meets a primitive. For triangles (u, v) are the barycentric coordinates of the
/// second and third vertex.
struct Hit {
    float t = std::numeric_limits<float>::infinity();
    float u = 0.0F;
    float v = 0.0F;
    std::uint32_t prim = 0;
};

}  // namespace coppice
