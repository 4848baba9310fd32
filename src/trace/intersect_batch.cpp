// Batched ray queries of a k-d tree: each ray by itself, in ranges shared among tasks.

#include "coppice/trace/intersect.h"

#include "base/batch.h"
#include "base/rows.h"

namespace coppice::inline v0 {

void intersect(const KdTree& tree, TriangleMeshView mesh, std::span<const Ray> rays,
               std::span<Hit> hits, int threads) {
    require_room("intersect", rays.size(), hits.size());
    for_each_query(rays.size(), threads, [&](std::size_t i) {
        hits[i] = intersect(tree, mesh, rays[i]).value_or(Hit{});
    });
}

void occluded(const KdTree& tree, TriangleMeshView mesh, std::span<const Ray> rays,
              std::span<std::uint8_t> is_occluded, int threads) {
    require_room("occluded", rays.size(), is_occluded.size());
    for_each_query(rays.size(), threads,
                   [&](std::size_t i) { is_occluded[i] = occluded(tree, mesh, rays[i]) ? 1 : 0; });
}

void intersect_all(const KdTree& tree, TriangleMeshView mesh, std::span<const Ray> rays,
                   std::span<Hit> hits, std::span<std::size_t> counts, int threads) {
    require_room("intersect_all", rays.size(), counts.size());
    for_each_row("intersect_all", rays.size(), hits, threads,
                 [&](std::size_t i, std::span<Hit> row) {
                     counts[i] = intersect_all(tree, mesh, rays[i], row);
                 });
}

void count_hits(const KdTree& tree, TriangleMeshView mesh, std::span<const Ray> rays,
                std::span<std::size_t> counts, int threads) {
    require_room("count_hits", rays.size(), counts.size());
    for_each_query(rays.size(), threads,
                   [&](std::size_t i) { counts[i] = count_hits(tree, mesh, rays[i]); });
}

}  // namespace coppice::inline v0
