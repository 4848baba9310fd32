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

/// Finds triangles by their place with an 8-wide tree: the nearest, the k nearest, those within a
/// distance, those that overlap a box. What is found equals brute_force_*() to the bit, on every
/// instruction set: distances are those of closest_point(), overlaps those of overlaps(), and of
/// equally near triangles the lowest id comes first.
///
/// Queries are reentrant, allocate nothing and never throw, but for the batched ones, which start
/// tasks, and throw Error(invalid_argument) for spans that do not fit together and for negative
/// `threads` (0 = all). Nothing is found near a
/// point that is not finite, within a distance that is negative or NaN, or in a box that is empty.
/// Distances are inclusive, in the units of the mesh.
class COPPICE_EXPORT MeshSearch {
public:
    /// No limit on the distance.
    static constexpr float anywhere = std::numeric_limits<float>::infinity();

    /// Keeps the tree's arrays alive. Notes which triangles are in several leaves, in O(triangles)
    /// and a bit for each. Throws Error(invalid_argument) like choose_isa().
    explicit MeshSearch(Bvh8 tree);

    /// The same with the kernels of one of available_isas().
    MeshSearch(Bvh8 tree, Isa isa);

    /// The triangle nearest to a point, if one is within `max_distance`.
    [[nodiscard]] SurfaceNeighbor nearest(Vec3f point,
                                          float max_distance = anywhere) const noexcept;

    /// The up to found.size() nearest triangles, in order. Returns how many there are.
    [[nodiscard]] std::size_t nearest_k(Vec3f point, std::span<SurfaceNeighbor> found,
                                        float max_distance = anywhere) const noexcept;

    /// Calls `visit` with all triangles within a distance, each once, in no particular order.
    void for_each_within(Vec3f center, float radius, Visitor<SurfaceNeighbor> visit) const noexcept;

    /// Calls `visit` with the ids of all triangles that overlap a closed box, each once, in no
    /// particular order.
    void for_each_overlapping(const Aabb& box, Visitor<std::uint32_t> visit) const noexcept;

    /// nearest() of many points at once: found[i] is that of points[i].
    void nearest(std::span<const Vec3f> points, std::span<SurfaceNeighbor> found,
                 float max_distance = anywhere, int threads = 0) const;

    /// nearest_k() of many points: their rows in `found` follow one another, k = found.size() /
    /// points.size() each; rows are filled up with what is not is_found().
    void nearest_k(std::span<const Vec3f> points, std::span<SurfaceNeighbor> found,
                   float max_distance = anywhere, int threads = 0) const;

    /// for_each_within() of many centers: counts[i] is the number of triangles there, and row i of
    /// `found` (see nearest_k()) has the first that were found, as many as it can hold.
    void within(std::span<const Vec3f> centers, float radius, std::span<SurfaceNeighbor> found,
                std::span<std::size_t> counts, int threads = 0) const;

    /// for_each_overlapping() of many boxes, in the same form.
    void overlapping(std::span<const Aabb> boxes, std::span<std::uint32_t> found,
                     std::span<std::size_t> counts, int threads = 0) const;

    /// The tree that is searched.
    [[nodiscard]] const Bvh8& tree() const noexcept { return tree_; }

private:
    Bvh8 tree_;
    std::shared_ptr<const std::vector<std::uint64_t>> repeated_;  // a bit by id; empty if none is
    const MeshSearchKernels* kernels_;
};

}  // namespace coppice::inline v0
