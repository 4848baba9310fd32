// The rays that contestants are measured with: what a path tracer with one bounce would send.
// Secondary rays start off their surface by a 1e-5th of the scene's size, so that what they hit
// does not hang on how a tracer rounds. Everything depends on the camera, the hits and the seed
// alone, in double precision; all contestants get the same buffers.
// Source: [Pharr2016] sec. 13.6.3 (cosine-weighted directions).

#include "scenes/ray_sets.h"

#include "coppice/base/rng.h"

#include "scenes/vector_math.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace coppice::lab {

namespace {

/// The point of a hit with the unit normal on the side that the ray came from.
struct SurfacePoint {
    Vec3d position;
    Vec3d normal;
};

SurfacePoint surface_point(TriangleMeshView mesh, const Ray& ray, const Hit& hit) {
    const Triangle triangle = mesh.triangle(hit.prim);
    const Vec3d a = to_double(triangle[0]);
    const Vec3d direction = to_double(ray.direction);
    Vec3d normal = cross(to_double(triangle[1]) - a, to_double(triangle[2]) - a);
    const double size = render::length(normal);
    // A triangle without area has no normal: back to where the ray came from.
    normal = size > 0.0 ? (1.0 / size) * normal : (-1.0 / render::length(direction)) * direction;
    if (dot(normal, direction) > 0.0) normal = -1.0 * normal;
    return {to_double(ray.origin) + static_cast<double>(hit.t) * direction, normal};
}

/// How far off a surface secondary rays start.
double offset_for(TriangleMeshView mesh) {
    const Aabb box = bounds_of(mesh.vertices());
    const Vec3d diagonal{box.extent(Axis::x), box.extent(Axis::y), box.extent(Axis::z)};
    return 1e-5 * render::length(diagonal);
}

/// Calls `make(index, point, start)` for every hit and gathers the rays.
template <typename MakeRay>
std::vector<Ray> rays_from_hits(TriangleMeshView mesh, std::span<const Ray> rays,
                                std::span<const Hit> hits, MakeRay&& make) {
    const double offset = offset_for(mesh);
    std::vector<Ray> made;
    made.reserve(rays.size());
    for (std::size_t i = 0; i < rays.size(); ++i) {
        if (!hits[i].is_hit()) continue;
        const SurfacePoint point = surface_point(mesh, rays[i], hits[i]);
        made.push_back(make(i, point, to_float(point.position + offset * point.normal)));
    }
    return made;
}

/// A unit vector around a unit normal, distributed as the cosine to it.
Vec3d cosine_weighted(Vec3d normal, double u, double v) {
    const Vec3d other = std::abs(normal.x) < 0.9 ? Vec3d{1.0, 0.0, 0.0} : Vec3d{0.0, 1.0, 0.0};
    const Vec3d side = cross(normal, other);
    const Vec3d tangent = (1.0 / render::length(side)) * side;
    const double radius = std::sqrt(u);
    const double angle = 2.0 * std::numbers::pi * v;
    return radius * std::cos(angle) * tangent + radius * std::sin(angle) * cross(normal, tangent) +
           std::sqrt(1.0 - u) * normal;
}

}  // namespace

std::span<const RayKindEntry> ray_kind_registry() {
    static constexpr std::array entries{
        RayKindEntry{"primary", "one ray through each pixel; closest hit", RayKind::primary},
        RayKindEntry{"shadow", "one from each primary hit to a point light; any hit",
                     RayKind::shadow},
        RayKindEntry{"diffuse", "one cosine-weighted bounce off each primary hit; closest hit",
                     RayKind::diffuse},
        RayKindEntry{"random", "random lines through the scene's box; closest hit",
                     RayKind::random},
        RayKindEntry{"axis", "parallel to an axis through a vertex; closest hit", RayKind::axis},
        RayKindEntry{"grazing", "in the plane of a face, along it; closest hit", RayKind::grazing},
    };
    return entries;
}

std::string_view name_of(RayKind kind) noexcept {
    return ray_kind_registry()[index_of(kind)].name;
}

std::span<const RayKindEntry> rendering_ray_kinds() {
    return ray_kind_registry().first(3);
}

std::vector<Ray> primary_rays(const render::Camera& camera, int size) {
    const render::CameraRays pixels(camera, size, size);
    std::vector<Ray> rays;
    rays.reserve(static_cast<std::size_t>(size) * static_cast<std::size_t>(size));
    for (int y = 0; y < size; ++y) {
        for (int x = 0; x < size; ++x) {
            rays.push_back(pixels.through(x, y));
        }
    }
    return rays;
}

std::vector<Ray> shadow_rays(TriangleMeshView mesh, std::span<const Ray> rays,
                             std::span<const Hit> hits, Vec3f light) {
    return rays_from_hits(mesh, rays, hits,
                          [&](std::size_t /*index*/, const SurfacePoint& /*point*/, Vec3f start) {
                              return Ray{start, light - start, 0.0F, 1.0F};
                          });
}

std::vector<Ray> diffuse_rays(TriangleMeshView mesh, std::span<const Ray> rays,
                              std::span<const Hit> hits, std::uint64_t seed) {
    return rays_from_hits(
        mesh, rays, hits, [&](std::size_t index, const SurfacePoint& point, Vec3f start) {
            const Vec3d direction =
                cosine_weighted(point.normal, random_unit(seed, 2 * std::uint64_t{index}),
                                random_unit(seed, 2 * std::uint64_t{index} + 1));
            return Ray{start, to_float(direction)};
        });
}

}  // namespace coppice::lab
