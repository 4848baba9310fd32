#include "coppice/query/point_search.h"

#include "coppice/base/error.h"

#include "base/out_of_memory.h"
#include "base/rows.h"
#include "query/kernels/point_search.h"
#include "query/limit.h"

#include <fmt/format.h>

#include <utility>

namespace coppice::inline v0 {
namespace {

std::size_t row_of(std::size_t reference_count) noexcept {
    return reference_count + point_lanes;
}

// The coordinates of the points that a tree refers to: a row for each axis, padded with zeros.
std::vector<float> gather(std::span<const std::uint32_t> references, PointCloudView points) {
    const std::size_t row = row_of(references.size());
    std::vector<float> coordinates(3 * row);
    for (std::size_t i = 0; i < references.size(); ++i) {
        if (references[i] >= points.size()) {
            throw Error(ErrorCode::invalid_argument,
                        fmt::format("the tree refers to point {}, but there are {} points",
                                    references[i], points.size()));
        }
        const Vec3f point = points.points()[references[i]];
        coordinates[i] = point.x;
        coordinates[row + i] = point.y;
        coordinates[2 * row + i] = point.z;
    }
    return coordinates;
}

}  // namespace

PointSearch::PointSearch(KdTree tree, PointCloudView points)
    : PointSearch(std::move(tree), points, choose_isa()) {}

PointSearch::PointSearch(KdTree tree, PointCloudView points, Isa isa)
    : tree_(with_memory_errors("the search",
                               [&] { return std::make_shared<const KdTree>(std::move(tree)); })),
      coordinates_(with_memory_errors("the search",
                                      [&] {
                                          return std::make_shared<const std::vector<float>>(
                                              gather(tree_->references(), points));
                                      })),
      kernels_(&point_search_kernels_for(isa)) {}

SearchedPoints PointSearch::searched() const noexcept {
    const std::size_t row = row_of(tree_->references().size());
    const float* x = coordinates_->data();
    return {*tree_, x, x + row, x + 2 * row};
}

Neighbor PointSearch::nearest(Vec3f point, float max_distance) const noexcept {
    Neighbor found;
    if (is_searchable(point, max_distance)) {
        kernels_->nearest(searched(), point, squared(max_distance), found);
    }
    return found;
}

std::size_t PointSearch::nearest_k(Vec3f point, std::span<Neighbor> found,
                                   float max_distance) const noexcept {
    if (found.empty() || !is_searchable(point, max_distance)) return 0;
    return kernels_->nearest_k(searched(), point, squared(max_distance), found);
}

void PointSearch::for_each_within(Vec3f center, float radius,
                                  Visitor<Neighbor> visit) const noexcept {
    if (!is_searchable(center, radius)) return;
    kernels_->within(searched(), center, squared(radius), visit);
}

void PointSearch::for_each_overlapping(const Aabb& box,
                                       Visitor<std::uint32_t> visit) const noexcept {
    if (!box.is_empty()) kernels_->overlapping(searched(), box, visit);
}

void PointSearch::nearest(std::span<const Vec3f> points, std::span<Neighbor> found,
                          float max_distance, int threads) const {
    require_room("nearest", points.size(), found.size());
    for_each_query(points.size(), threads,
                   [&](std::size_t i) { found[i] = nearest(points[i], max_distance); });
}

void PointSearch::nearest_k(std::span<const Vec3f> points, std::span<Neighbor> found,
                            float max_distance, int threads) const {
    fill_rows("nearest_k", points.size(), found, threads,
              [&](std::size_t i, std::span<Neighbor> row) {
                  return nearest_k(points[i], row, max_distance);
              });
}

void PointSearch::within(std::span<const Vec3f> centers, float radius, std::span<Neighbor> found,
                         std::span<std::size_t> counts, int threads) const {
    require_room("within", centers.size(), counts.size());
    write_rows("within", found, counts, threads, [&](std::size_t i, Visitor<Neighbor> visit) {
        for_each_within(centers[i], radius, visit);
    });
}

void PointSearch::overlapping(std::span<const Aabb> boxes, std::span<std::uint32_t> found,
                              std::span<std::size_t> counts, int threads) const {
    require_room("overlapping", boxes.size(), counts.size());
    write_rows("overlapping", found, counts, threads,
               [&](std::size_t i, Visitor<std::uint32_t> visit) {
                   for_each_overlapping(boxes[i], visit);
               });
}

}  // namespace coppice::inline v0
