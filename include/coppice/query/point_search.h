#pragma once

#include "coppice/base/cpu.h"
#include "coppice/export.h"
#include "coppice/geom/aabb.h"
#include "coppice/geom/point_cloud.h"
#include "coppice/query/neighbor.h"
#include "coppice/query/visitor.h"
#include "coppice/tree/kd_tree.h"

#include <cstddef>
#include <cstdint>
#include <limits>
#include <memory>
#include <span>
#include <vector>

namespace coppice::inline v0 {

struct PointSearchKernels;
struct SearchedPoints;

/// Finds points of a cloud by their place with a k-d tree: the nearest, the k nearest, those within
/// a distance, those in a box. What is found equals brute_force_*() to the bit, on every
/// instruction set: distances are computed in double precision, and of equally near points the
/// lowest id comes first.
///
/// Queries are reentrant, allocate nothing and never throw, but for the batched ones, which start
/// tasks, and throw Error(invalid_argument) for spans that do not fit together and for negative
/// `threads` (0 = all). Nothing is found near a
/// point that is not finite, within a distance that is negative or NaN, or in a box that is empty.
/// Distances are inclusive, in the units of the points.
class COPPICE_EXPORT PointSearch {
public:
    /// No limit on the distance.
    static constexpr float anywhere = std::numeric_limits<float>::infinity();

    /// Takes over a tree that was built for these points, and copies them in the order of its
    /// leaves; the view need not outlive the call. Throws Error(invalid_argument) if the tree
    /// refers to points that do not exist, and like choose_isa().
    PointSearch(KdTree tree, PointCloudView points);

    /// The same with the kernels of one of available_isas().
    PointSearch(KdTree tree, PointCloudView points, Isa isa);

    /// The point nearest to a place, if one is within `max_distance`.
    [[nodiscard]] Neighbor nearest(Vec3f point, float max_distance = anywhere) const noexcept;

    /// The up to found.size() nearest points, in order. Returns how many there are.
    [[nodiscard]] std::size_t nearest_k(Vec3f point, std::span<Neighbor> found,
                                        float max_distance = anywhere) const noexcept;

    /// Calls `visit` with all points within a distance, in no particular order.
    void for_each_within(Vec3f center, float radius, Visitor<Neighbor> visit) const noexcept;

    /// Calls `visit` with the ids of all points in a closed box, in no particular order.
    void for_each_overlapping(const Aabb& box, Visitor<std::uint32_t> visit) const noexcept;

    /// nearest() of many places at once: found[i] is that of points[i].
    void nearest(std::span<const Vec3f> points, std::span<Neighbor> found,
                 float max_distance = anywhere, int threads = 0) const;

    /// nearest_k() of many places: their rows in `found` follow one another, k = found.size() /
    /// points.size() each; rows are filled up with what is not is_found().
    void nearest_k(std::span<const Vec3f> points, std::span<Neighbor> found,
                   float max_distance = anywhere, int threads = 0) const;

    /// for_each_within() of many centers: counts[i] is the number of points there, and row i of
    /// `found` (see nearest_k()) has the first that were found, as many as it can hold.
    void within(std::span<const Vec3f> centers, float radius, std::span<Neighbor> found,
                std::span<std::size_t> counts, int threads = 0) const;

    /// for_each_overlapping() of many boxes, in the same form.
    void overlapping(std::span<const Aabb> boxes, std::span<std::uint32_t> found,
                     std::span<std::size_t> counts, int threads = 0) const;

    /// The tree that is searched.
    [[nodiscard]] const KdTree& tree() const noexcept { return *tree_; }

private:
    [[nodiscard]] SearchedPoints searched() const noexcept;

    std::shared_ptr<const KdTree> tree_;
    std::shared_ptr<const std::vector<float>> coordinates_;  // x, y, z; as references, padded
    const PointSearchKernels* kernels_;
};

}  // namespace coppice::inline v0
