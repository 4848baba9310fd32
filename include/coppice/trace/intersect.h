#pragma once

#include "coppice/export.h"
#include "coppice/geom/ray.h"
#include "coppice/geom/triangle_mesh.h"
#include "coppice/trace/traversal_counts.h"
#include "coppice/tree/kd_tree.h"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

namespace coppice::inline v0 {

// Ray queries of a mesh with a k-d tree over its triangles. All are reentrant and allocate nothing.
// A ray that is not traceable (is_traceable()) hits nothing.

/// The closest hit of a ray, or nothing. `tree` must be built for the triangles of `mesh`. Equals
/// brute_force_intersect(): of equally close hits the lowest id wins.
[[nodiscard]] COPPICE_EXPORT std::optional<Hit> intersect(const KdTree& tree, TriangleMeshView mesh,
                                                          const Ray& ray) noexcept;

/// The same, and adds to `counts` what the traversal did.
[[nodiscard]] COPPICE_EXPORT std::optional<Hit> intersect(const KdTree& tree, TriangleMeshView mesh,
                                                          const Ray& ray,
                                                          TraversalCounts& counts) noexcept;

/// True if the ray hits any triangle. Stops at the first hit found.
[[nodiscard]] COPPICE_EXPORT bool occluded(const KdTree& tree, TriangleMeshView mesh,
                                           const Ray& ray) noexcept;

/// The same, and adds to `counts` what the traversal did.
[[nodiscard]] COPPICE_EXPORT bool occluded(const KdTree& tree, TriangleMeshView mesh,
                                           const Ray& ray, TraversalCounts& counts) noexcept;

/// Writes the first hits in order of distance, then of id, to the front of `hits`, at most
/// hits.size() of them. Only hits after `*after` in that order count; null means all. Returns the
/// number written; fewer than hits.size() means that no more follow. A triangle gives one hit
/// however often the tree refers to it. `after` may point into `hits`.
[[nodiscard]] COPPICE_EXPORT std::size_t intersect_all(const KdTree& tree, TriangleMeshView mesh,
                                                       const Ray& ray, std::span<Hit> hits,
                                                       const Hit* after = nullptr) noexcept;

/// The number of triangles that the ray hits.
[[nodiscard]] COPPICE_EXPORT std::size_t count_hits(const KdTree& tree, TriangleMeshView mesh,
                                                    const Ray& ray) noexcept;

// Batched queries, on at most `threads` threads (0 = all hardware threads). They throw
// Error(invalid_argument) if the lengths of the spans do not fit or `threads` is negative.

/// Writes the closest hit of rays[i] to hits[i]; without a hit, hits[i].is_hit() is false.
COPPICE_EXPORT void intersect(const KdTree& tree, TriangleMeshView mesh, std::span<const Ray> rays,
                              std::span<Hit> hits, int threads = 0);

/// Sets is_occluded[i] to 1 if rays[i] hits any triangle, otherwise to 0.
COPPICE_EXPORT void occluded(const KdTree& tree, TriangleMeshView mesh, std::span<const Ray> rays,
                             std::span<std::uint8_t> is_occluded, int threads = 0);

/// The first k hits of each ray in order, k = hits.size() / rays.size(). Writes the hits of rays[i]
/// to hits[i * k] and the following, and their number to counts[i].
COPPICE_EXPORT void intersect_all(const KdTree& tree, TriangleMeshView mesh,
                                  std::span<const Ray> rays, std::span<Hit> hits,
                                  std::span<std::size_t> counts, int threads = 0);

/// Writes the number of triangles that rays[i] hits to counts[i].
COPPICE_EXPORT void count_hits(const KdTree& tree, TriangleMeshView mesh, std::span<const Ray> rays,
                               std::span<std::size_t> counts, int threads = 0);

}  // namespace coppice::inline v0
