#pragma once

#include "coppice/export.h"
#include "coppice/geom/ray.h"
#include "coppice/geom/triangle_mesh.h"

#include <cstddef>
#include <optional>
#include <span>

namespace coppice::inline v0 {

/// The closest hit of a ray, or nothing. Of hits at the same distance the lowest id wins. A ray
/// that is not traceable (is_traceable()) hits nothing. Tests every triangle: the reference for
/// tests of all traversals.
[[nodiscard]] COPPICE_EXPORT std::optional<Hit> brute_force_intersect(TriangleMeshView mesh,
                                                                      const Ray& ray) noexcept;

/// True if the ray hits any triangle. Tests every triangle until one is hit.
[[nodiscard]] COPPICE_EXPORT bool brute_force_occluded(TriangleMeshView mesh,
                                                       const Ray& ray) noexcept;

/// Writes the first hits in order of distance, then of id, to the front of `hits`, at most
/// hits.size() of them. Only hits after `*after` in that order count; null means all. Returns the
/// number written. Tests every triangle: the reference for tests of intersect_all().
[[nodiscard]] COPPICE_EXPORT std::size_t brute_force_intersect_all(
    TriangleMeshView mesh, const Ray& ray, std::span<Hit> hits,
    const Hit* after = nullptr) noexcept;

/// The number of triangles that the ray hits. Tests every triangle.
[[nodiscard]] COPPICE_EXPORT std::size_t brute_force_count_hits(TriangleMeshView mesh,
                                                                const Ray& ray) noexcept;

}  // namespace coppice::inline v0
