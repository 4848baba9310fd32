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

/// Spatial queries for points of a cloud in a k-d tree: the nearest, the k nearest, those within a
/// distance, those in a box. Results equal those of brute_force_*() to the bit, on every
/// instruction set. Distances are computed in double precision. Of equally near points the lowest
/// id comes first.
///
/// Queries of one point or box are reentrant, allocate nothing and never throw. Batched queries
/// start tasks; they throw Error(invalid_argument) for spans whose lengths do not fit and for
/// negative `threads` (0 = all hardware threads). Nothing is found for a point that is not finite,
/// a distance that is negative or NaN, or an empty box. Distances are inclusive, in the units of
/// the points.
class COPPICE_EXPORT PointSearch {
public:
    /// No limit on the distance.
    static constexpr float anywhere = std::numeric_limits<float>::infinity();

    /// Takes a tree that was built for `points`, and copies the points in the order of its leaves.
    /// The array behind `points` need not outlive the call. Throws Error(invalid_argument) if the
    /// tree refers to points that do not exist, or if COPPICE_ISA is invalid (choose_isa()).
    PointSearch(KdTree tree, PointCloudView points);

    /// Prepares a tree for the kernels of `isa`, which must be one of available_isas().
    PointSearch(KdTree tree, PointCloudView points, Isa isa);

    /// The point of the cloud nearest to `point`. If none is within `max_distance`, the result's
    /// is_found() is false.
    [[nodiscard]] Neighbor nearest(Vec3f point, float max_distance = anywhere) const noexcept;

    /// Writes the nearest points to the front of `found` in order, at most found.size() of them.
    /// Returns their number.
    [[nodiscard]] std::size_t nearest_k(Vec3f point, std::span<Neighbor> found,
                                        float max_distance = anywhere) const noexcept;

    /// Calls `visit` for every point within a distance, in no particular order.
    void for_each_within(Vec3f center, float radius, Visitor<Neighbor> visit) const noexcept;

    /// Calls `visit` with the id of every point in a closed box, in no particular order.
    void for_each_overlapping(const Aabb& box, Visitor<std::uint32_t> visit) const noexcept;

    /// nearest() for many points: found[i] is the result for points[i].
    void nearest(std::span<const Vec3f> points, std::span<Neighbor> found,
                 float max_distance = anywhere, int threads = 0) const;

    /// nearest_k() for many points, with k = found.size() / points.size(). The results for
    /// points[i] are found[i * k] and the following; unused entries of a row have is_found() false.
    void nearest_k(std::span<const Vec3f> points, std::span<Neighbor> found,
                   float max_distance = anywhere, int threads = 0) const;

    /// for_each_within() for many centers: counts[i] is the number of points found for centers[i].
    /// Row i of `found` (see nearest_k()) holds as many of them as fit, in no particular order.
    void within(std::span<const Vec3f> centers, float radius, std::span<Neighbor> found,
                std::span<std::size_t> counts, int threads = 0) const;

    /// for_each_overlapping() for many boxes, with results in the form of within().
    void overlapping(std::span<const Aabb> boxes, std::span<std::uint32_t> found,
                     std::span<std::size_t> counts, int threads = 0) const;

    /// The tree that is searched.
    [[nodiscard]] const KdTree& tree() const noexcept { return *tree_; }

private:
    [[nodiscard]] SearchedPoints searched() const noexcept;

    std::shared_ptr<const KdTree> tree_;
    std::shared_ptr<const std::vector<float>> coordinates_;  // rows x, y, z by reference, padded
    const PointSearchKernels* kernels_;
};

}  // namespace coppice::inline v0
