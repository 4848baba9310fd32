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

// Queries of a mesh with a k-d tree over its triangles. All are reentrant and allocate nothing; a
// ray that is not traceable hits nothing.

/// The closest hit of a ray in a mesh, found with a tree over its triangles. Equals
/// brute_force_intersect(), the lowest id of equally close hits included.
[[nodiscard]] COPPICE_EXPORT std::optional<Hit> intersect(const KdTree& tree, TriangleMeshView mesh,
                                                          const Ray& ray) noexcept;

/// The same, and adds to `counts` what the traversal did.
[[nodiscard]] COPPICE_EXPORT std::optional<Hit> intersect(const KdTree& tree, TriangleMeshView mesh,
                                                          const Ray& ray,
                                                          TraversalCounts& counts) noexcept;

/// True if the ray hits any triangle; stops at the first found.
[[nodiscard]] COPPICE_EXPORT bool occluded(const KdTree& tree, TriangleMeshView mesh,
                                           const Ray& ray) noexcept;

/// The same, and adds to `counts` what the traversal did.
[[nodiscard]] COPPICE_EXPORT bool occluded(const KdTree& tree, TriangleMeshView mesh,
                                           const Ray& ray, TraversalCounts& counts) noexcept;

/// The first hits.size() hits of a ray by distance, equally close ones by id, of those that come
/// behind `*after` in that order (behind nothing if it is null). Returns how many there are, which
/// are written to the front of `hits`; fewer than hits.size() means that no more follow. A triangle
/// is one hit however often the tree refers to it. `after` may point into `hits`.
[[nodiscard]] COPPICE_EXPORT std::size_t intersect_all(const KdTree& tree, TriangleMeshView mesh,
                                                       const Ray& ray, std::span<Hit> hits,
                                                       const Hit* after = nullptr) noexcept;

/// How many triangles the ray hits.
[[nodiscard]] COPPICE_EXPORT std::size_t count_hits(const KdTree& tree, TriangleMeshView mesh,
                                                    const Ray& ray) noexcept;

// The same for many rays, on at most `threads` threads (0 = all). They throw
// Error(invalid_argument) for spans that do not fit together and for negative `threads`.

/// The closest hit of each ray; one that is not is_hit() where there is none.
COPPICE_EXPORT void intersect(const KdTree& tree, TriangleMeshView mesh, std::span<const Ray> rays,
                              std::span<Hit> hits, int threads = 0);

/// 1 for each ray that hits anything, else 0.
COPPICE_EXPORT void occluded(const KdTree& tree, TriangleMeshView mesh, std::span<const Ray> rays,
                             std::span<std::uint8_t> is_occluded, int threads = 0);

/// The first k hits of each ray in order, k = hits.size() / rays.size(): those of ray i are
/// hits[i * k] and the following, counts[i] of them.
COPPICE_EXPORT void intersect_all(const KdTree& tree, TriangleMeshView mesh,
                                  std::span<const Ray> rays, std::span<Hit> hits,
                                  std::span<std::size_t> counts, int threads = 0);

/// How many triangles each ray hits.
COPPICE_EXPORT void count_hits(const KdTree& tree, TriangleMeshView mesh, std::span<const Ray> rays,
                               std::span<std::size_t> counts, int threads = 0);

}  // namespace coppice::inline v0
