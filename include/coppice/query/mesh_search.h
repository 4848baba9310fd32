#pragma once

#include "coppice/base/cpu.h"
#include "coppice/export.h"
#include "coppice/geom/aabb.h"
#include "coppice/query/neighbor.h"
#include "coppice/query/visitor.h"
#include "coppice/tree/bvh8.h"

#include <cstddef>
#include <cstdint>
#include <limits>
#include <memory>
#include <span>
#include <vector>

namespace coppice::inline v0 {

struct MeshSearchKernels;

/// Spatial queries for triangles in an 8-wide tree: the nearest, the k nearest, those within a
/// distance, those that overlap a box. Results equal those of brute_force_*() to the bit, on every
/// instruction set. Distances are those of closest_point(), overlaps those of overlaps(). Of
/// equally near triangles the lowest id comes first.
///
/// Queries of one point or box are reentrant, allocate nothing and never throw. Batched queries
/// start tasks; they throw Error(invalid_argument) for spans whose lengths do not fit and for
/// negative `threads` (0 = all hardware threads). Nothing is found for a point that is not finite,
/// a distance that is negative or NaN, or an empty box. Distances are inclusive, in the units of
/// the mesh.
class COPPICE_EXPORT MeshSearch {
public:
    /// No limit on the distance.
    static constexpr float anywhere = std::numeric_limits<float>::infinity();

    /// Prepares a tree for searching and keeps its arrays alive. Finds the triangles that are in
    /// several leaves, in O(triangles) time and one bit for each. Throws Error(invalid_argument) if
    /// COPPICE_ISA is invalid; see choose_isa().
    explicit MeshSearch(Bvh8 tree);

    /// Prepares a tree for the kernels of `isa`, which must be one of available_isas().
    MeshSearch(Bvh8 tree, Isa isa);

    /// The triangle nearest to a point. If none is within `max_distance`, the result's is_found()
    /// is false.
    [[nodiscard]] SurfaceNeighbor nearest(Vec3f point,
                                          float max_distance = anywhere) const noexcept;

    /// Writes the nearest triangles to the front of `found` in order, at most found.size() of them.
    /// Returns their number.
    [[nodiscard]] std::size_t nearest_k(Vec3f point, std::span<SurfaceNeighbor> found,
                                        float max_distance = anywhere) const noexcept;

    /// Calls `visit` for every triangle within a distance, once each, in no particular order.
    void for_each_within(Vec3f center, float radius, Visitor<SurfaceNeighbor> visit) const noexcept;

    /// Calls `visit` with the id of every triangle that overlaps a closed box, once each, in no
    /// particular order.
    void for_each_overlapping(const Aabb& box, Visitor<std::uint32_t> visit) const noexcept;

    /// nearest() for many points: found[i] is the result for points[i].
    void nearest(std::span<const Vec3f> points, std::span<SurfaceNeighbor> found,
                 float max_distance = anywhere, int threads = 0) const;

    /// nearest_k() for many points, with k = found.size() / points.size(). The results for
    /// points[i] are found[i * k] and the following; unused entries of a row have is_found() false.
    void nearest_k(std::span<const Vec3f> points, std::span<SurfaceNeighbor> found,
                   float max_distance = anywhere, int threads = 0) const;

    /// for_each_within() for many centers: counts[i] is the number of triangles found for
    /// centers[i]. Row i of `found` (see nearest_k()) holds as many of them as fit, in no
    /// particular order.
    void within(std::span<const Vec3f> centers, float radius, std::span<SurfaceNeighbor> found,
                std::span<std::size_t> counts, int threads = 0) const;

    /// for_each_overlapping() for many boxes, with results in the form of within().
    void overlapping(std::span<const Aabb> boxes, std::span<std::uint32_t> found,
                     std::span<std::size_t> counts, int threads = 0) const;

    /// The tree that is searched.
    [[nodiscard]] const Bvh8& tree() const noexcept { return tree_; }

private:
    Bvh8 tree_;
    std::shared_ptr<const std::vector<std::uint64_t>> repeated_;  // a bit per id; empty if all 0
    const MeshSearchKernels* kernels_;
};

}  // namespace coppice::inline v0
