#pragma once

#include "render/integrator.h"
#include "render/surface.h"
#include "scenes/vector_math.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace coppice::render {

/// True if a surface reflects like a mirror.
[[nodiscard]] inline bool is_mirror(const Material& material) noexcept {
    return material.illumination >= 3 && largest(to_double(material.specular)) > 0.0;
}

/// A direction after a mirror at right angles to `normal`.
[[nodiscard]] inline Vec3d mirrored(Vec3d direction, Vec3d normal) noexcept {
    return direction - 2.0 * dot(direction, normal) * normal;
}

/// The ray that a mirror sends on; never into the surface.
[[nodiscard]] inline Ray mirror_ray(const Surface& surface, Vec3d direction) noexcept {
    Vec3d reflected = mirrored(direction, surface.normal);
    if (!(dot(reflected, surface.facing) > 0.0)) reflected = mirrored(direction, surface.facing);
    return {surface.start(), to_float(normalized(reflected))};
}

/// A direction around the surface's normal with a density of cosine / pi; never into the surface.
/// Source: [Pharr2016] sec. 13.6.3.
[[nodiscard]] inline Vec3d cosine_weighted(const Surface& surface, PixelSamples& random) noexcept {
    const auto [u, v] = random.next_2d();
    const Tangents tangents = tangents_of(surface.normal);
    const double radius = std::sqrt(u);
    const double angle = 2.0 * std::numbers::pi * v;
    const Vec3d direction = radius * std::cos(angle) * tangents.first +
                            radius * std::sin(angle) * tangents.second +
                            std::sqrt(1.0 - u) * surface.normal;
    const bool is_outside = dot(direction, surface.facing) > 0.0;
    return is_outside ? direction : mirrored(direction, surface.facing);
}

/// Calls `add(sample, cosine)` for a point on each source of light that the surface sees.
template <typename Add>
void for_each_visible_light(const View& view, const Surface& surface, PixelSamples& random,
                            RayCounts& counts, const Add& add) {
    const auto take = [&](const LightSample& sample) {
        const double cosine = dot(sample.direction, surface.normal);
        if (!(cosine > 0.0) || !(dot(sample.direction, surface.facing) > 0.0)) return;
        const Vec3f start = surface.start();
        ++counts.shadow;
        if (view.tracer->occluded({start, sample.target - start, 0.0F, 1.0F})) return;
        add(sample, cosine);
    };
    view.lighting->for_each_sample(surface.position, random, take);
}

}  // namespace coppice::render
