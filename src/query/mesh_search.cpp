#include "coppice/query/mesh_search.h"

#include "base/out_of_memory.h"
#include "base/rows.h"
#include "query/kernels/mesh_search.h"
#include "query/limit.h"

#include <algorithm>
#include <utility>

namespace coppice::inline v0 {
namespace {

using Bits = std::vector<std::uint64_t>;

// Sets a bit and returns its old value. Extends the array as needed.
bool test_and_set(Bits& bits, std::uint32_t at) {
    const std::size_t word = at / 64;
    if (word >= bits.size()) bits.resize(std::max<std::size_t>(word + 1, 2 * bits.size()));
    const std::uint64_t bit = std::uint64_t{1} << at % 64;
    const bool was_set = (bits[word] & bit) != 0;
    bits[word] |= bit;
    return was_set;
}

// One bit per triangle, set if it is in more than one block. Empty if there is no such triangle.
Bits find_repeated(const Bvh8& tree) {
    Bits seen;
    Bits repeated;
    for (const TriangleBlock& block : tree.blocks()) {
        for (const std::uint32_t id : block.id) {
            if (id == TriangleBlock::no_triangle) break;
            if (test_and_set(seen, id)) test_and_set(repeated, id);
        }
    }
    if (!repeated.empty()) repeated.resize(seen.size());
    return repeated;
}

}  // namespace

MeshSearch::MeshSearch(Bvh8 tree) : MeshSearch(std::move(tree), choose_isa()) {}

MeshSearch::MeshSearch(Bvh8 tree, Isa isa)
    : tree_(std::move(tree)),
      repeated_(with_memory_errors(
          "the search", [&] { return std::make_shared<const Bits>(find_repeated(tree_)); })),
      kernels_(&mesh_search_kernels_for(isa)) {}

SurfaceNeighbor MeshSearch::nearest(Vec3f point, float max_distance) const noexcept {
    SurfaceNeighbor found;
    if (is_searchable(point, max_distance)) {
        kernels_->nearest({tree_, *repeated_}, point, squared(max_distance), found);
    }
    return found;
}

std::size_t MeshSearch::nearest_k(Vec3f point, std::span<SurfaceNeighbor> found,
                                  float max_distance) const noexcept {
    if (found.empty() || !is_searchable(point, max_distance)) return 0;
    return kernels_->nearest_k({tree_, *repeated_}, point, squared(max_distance), found);
}

void MeshSearch::for_each_within(Vec3f center, float radius,
                                 Visitor<SurfaceNeighbor> visit) const noexcept {
    if (!is_searchable(center, radius)) return;
    kernels_->within({tree_, *repeated_}, center, squared(radius), visit);
}

void MeshSearch::for_each_overlapping(const Aabb& box,
                                      Visitor<std::uint32_t> visit) const noexcept {
    if (!box.is_empty()) kernels_->overlapping({tree_, *repeated_}, box, visit);
}

void MeshSearch::nearest(std::span<const Vec3f> points, std::span<SurfaceNeighbor> found,
                         float max_distance, int threads) const {
    require_room("nearest", points.size(), found.size());
    for_each_query(points.size(), threads,
                   [&](std::size_t i) { found[i] = nearest(points[i], max_distance); });
}

void MeshSearch::nearest_k(std::span<const Vec3f> points, std::span<SurfaceNeighbor> found,
                           float max_distance, int threads) const {
    fill_rows("nearest_k", points.size(), found, threads,
              [&](std::size_t i, std::span<SurfaceNeighbor> row) {
                  return nearest_k(points[i], row, max_distance);
              });
}

void MeshSearch::within(std::span<const Vec3f> centers, float radius,
                        std::span<SurfaceNeighbor> found, std::span<std::size_t> counts,
                        int threads) const {
    require_room("within", centers.size(), counts.size());
    write_rows("within", found, counts, threads,
               [&](std::size_t i, Visitor<SurfaceNeighbor> visit) {
                   for_each_within(centers[i], radius, visit);
               });
}

void MeshSearch::overlapping(std::span<const Aabb> boxes, std::span<std::uint32_t> found,
                             std::span<std::size_t> counts, int threads) const {
    require_room("overlapping", boxes.size(), counts.size());
    write_rows("overlapping", found, counts, threads,
               [&](std::size_t i, Visitor<std::uint32_t> visit) {
                   for_each_overlapping(boxes[i], visit);
               });
}

}  // namespace coppice::inline v0
