// Light sources and points on them. Emitting triangles are drawn in proportion to area times
// luminance, by bisection of the running sum, so that the density per area depends on the emission
// alone: an integrator that hits an emitter by chance knows it without looking the triangle up.
// Source: [Pharr2016] sec. 14.2 (direct light), 13.6.5 (points on triangles), [Whitted1980].

#include "render/lighting.h"

#include "render/surface.h"
#include "scenes/vector_math.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace coppice::render {

namespace {

double luminance(Vec3f color) {
    return 0.2126 * color.x + 0.7152 * color.y + 0.0722 * color.z;
}

/// A point of the unit sphere, all alike.
Vec3d point_on_sphere(PixelSamples& random) {
    const auto [u, v] = random.next_2d();
    const double z = 1.0 - 2.0 * u;
    const double radius = std::sqrt(std::max(0.0, 1.0 - z * z));
    const double angle = 2.0 * std::numbers::pi * v;
    return {radius * std::cos(angle), radius * std::sin(angle), z};
}

Vec3d mixed(Vec3d a, Vec3d b, double share_of_b) {
    return (1.0 - share_of_b) * a + share_of_b * b;
}

}  // namespace

Vec3d Sky::radiance(Vec3d direction) const noexcept {
    if (color) return to_double(*color);
    constexpr Vec3d zenith{0.20, 0.28, 0.44};
    constexpr Vec3d horizon{0.46, 0.48, 0.50};
    constexpr Vec3d ground{0.16, 0.155, 0.15};
    const double height = dot(direction, normalized(to_double(up)));
    return height >= 0.0 ? mixed(horizon, zenith, std::sqrt(std::min(height, 1.0)))
                         : mixed(horizon, ground, std::sqrt(std::min(-height, 1.0)));
}

Emitters::Emitters(TriangleMeshView mesh, const MeshAttributes& attributes) {
    if (attributes.triangle_materials.empty()) return;
    for (std::uint32_t id = 0; id < mesh.size(); ++id) {
        const Vec3f emission = material_of(attributes, id).emission;
        if (!(luminance(emission) > 0.0)) continue;
        const double power = triangle_area(mesh.triangle(id)) * luminance(emission);
        if (!(power > 0.0)) continue;
        triangles_.push_back({mesh.triangle(id), emission, power_});
        power_ += power;
    }
}

double Emitters::area_density(Vec3f emission) const noexcept {
    return power_ > 0.0 ? luminance(emission) / power_ : 0.0;
}

std::optional<LightSample> Emitters::sample(Vec3d position, PixelSamples& random) const {
    const double chosen = random.next_1d() * power_;
    const auto after = std::partition_point(
        triangles_.begin(), triangles_.end(),
        [&](const Emitter& emitter) { return emitter.power_before <= chosen; });
    const Emitter& emitter = *(after - 1);
    const auto [u, v] = random.next_2d();
    const double root = std::sqrt(u);
    const TrianglePoint point = point_on(emitter.corners, root * (1.0 - v), root * v);

    const Vec3d across = position - point.position;
    const double distance = length(across);
    const Vec3d a = to_double(emitter.corners[0]);
    const Vec3d normal =
        normalized(cross(to_double(emitter.corners[1]) - a, to_double(emitter.corners[2]) - a));
    const double cosine = dot(normal, across) / distance;
    // NaN: the point itself. Emitters shine on both sides.
    if (!(std::abs(cosine) > 0.0)) return std::nullopt;
    const double density = area_density(emitter.emission) * distance * distance / std::abs(cosine);
    const Vec3d side = (cosine > 0.0 ? point.offset : -point.offset) * normal;
    return LightSample{to_float(point.position + side), (-1.0 / distance) * across,
                       (1.0 / density) * to_double(emitter.emission), density};
}

LightSample sample_lamp(const Lamp& lamp, Vec3d position, PixelSamples& random) {
    Vec3d target = to_double(lamp.position);
    if (lamp.radius > 0.0) target = target + lamp.radius * point_on_sphere(random);
    const double irradiance = std::numbers::pi * lamp.brightness;
    return {to_float(target), normalized(target - position),
            Vec3d{irradiance, irradiance, irradiance}};
}

}  // namespace coppice::render
