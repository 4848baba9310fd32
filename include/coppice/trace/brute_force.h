#pragma once

#include "coppice/export.h"
#include "coppice/geom/ray.h"
#include "coppice/geom/triangle_mesh.h"

#include <cstddef>
#include <optional>
#include <span>

namespace coppice::inline v0 {

/// The closest hit of a ray, by testing every triangle: the oracle of all traversals. Of hits at
/// the same distance the lowest id wins. A bad ray (NaN, zero direction, t_min > t_max) hits
/// nothing.
[[nodiscard]] COPPICE_EXPORT std::optional<Hit> brute_force_intersect(TriangleMeshView mesh,
                                                                      const Ray& ray) noexcept;

/// True if any triangle is hit.
[[nodiscard]] COPPICE_EXPORT bool brute_force_occluded(TriangleMeshView mesh,
                                                       const Ray& ray) noexcept;

/// The oracle of intersect_all(): the first hits.size() hits by distance and id that come behind
/// `*after`, or behind nothing if it is null. Returns how many there are.
[[nodiscard]] COPPICE_EXPORT std::size_t brute_force_intersect_all(
    TriangleMeshView mesh, const Ray& ray, std::span<Hit> hits,
    const Hit* after = nullptr) noexcept;

/// How many triangles are hit.
[[nodiscard]] COPPICE_EXPORT std::size_t brute_force_count_hits(TriangleMeshView mesh,
                                                                const Ray& ray) noexcept;

}  // namespace coppice::inline v0
