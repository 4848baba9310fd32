#pragma once

#include "coppice/geom/ray.h"
#include "coppice/geom/triangle_mesh.h"

#include "scenes/camera.h"

#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

namespace coppice::lab {

/// What a set of rays asks of a tree: any hit for shadow rays, the closest one for all others.
enum class RayKind {
    primary,  ///< one through each pixel of an image
    shadow,   ///< one from each primary hit to a point light; any hit
    diffuse,  ///< one bounce off each primary hit, cosine-weighted
    random,   ///< a random line through the scene's box
    axis,     ///< parallel to an axis, through a vertex
    grazing   ///< in the plane of a face, along it
};

/// A kind of rays under its name, with one line on what it is.
struct RayKindEntry {
    std::string_view name;
    std::string_view summary;
    RayKind kind;
};

/// All kinds of rays, in the order of the enumeration.
[[nodiscard]] std::span<const RayKindEntry> ray_kind_registry();

/// The stable lower-case name, e.g. "primary".
[[nodiscard]] std::string_view name_of(RayKind kind) noexcept;

/// The place of a kind in the registry, and in arrays that have one item for each.
[[nodiscard]] constexpr std::size_t index_of(RayKind kind) noexcept {
    return static_cast<std::size_t>(kind);
}

/// The first of them: what a renderer sends, and so what is measured.
[[nodiscard]] std::span<const RayKindEntry> rendering_ray_kinds();

/// One ray through each pixel of a square image, row by row from the top.
[[nodiscard]] std::vector<Ray> primary_rays(const render::Camera& camera, int size);

/// One ray from each hit of `rays` to the light, which is at t = 1. It starts a little off the
/// surface, on the side that was hit. `hits[i]` belongs to `rays[i]`; a miss has an infinite t.
[[nodiscard]] std::vector<Ray> shadow_rays(TriangleMeshView mesh, std::span<const Ray> rays,
                                           std::span<const Hit> hits, Vec3f light);

/// One ray from each hit of `rays` into a random direction, distributed as the cosine to the
/// surface's normal; that of ray i depends on (seed, i) alone. Starts as a shadow ray does.
[[nodiscard]] std::vector<Ray> diffuse_rays(TriangleMeshView mesh, std::span<const Ray> rays,
                                            std::span<const Hit> hits, std::uint64_t seed);

}  // namespace coppice::lab
