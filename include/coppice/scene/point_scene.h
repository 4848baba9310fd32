#pragma once

#include "coppice/builders/build_report.h"
#include "coppice/builders/kd_options.h"
#include "coppice/export.h"
#include "coppice/query/point_search.h"

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace coppice::inline v0 {

/// Points together with the k-d tree to search them. Queries are reentrant.
class COPPICE_EXPORT PointScene {
public:
    /// What searches are fastest with: the thesis's tree of points as it is after the refill, from
    /// a sample of one in 32, split in the middle.
    [[nodiscard]] static KdOptions search_options();

    /// Takes over the points and builds their tree by search_options(). If that leaves many points
    /// together, because others are very far away, it is built once more with medians for planes.
    /// Throws Error like build_kd_tree().
    explicit PointScene(std::vector<Vec3f> points);

    /// The same with one tree by other options.
    PointScene(std::vector<Vec3f> points, const KdOptions& options);

    /// The point nearest to a place, if one is within `max_distance`; see PointSearch, also for the
    /// three below.
    [[nodiscard]] Neighbor nearest(Vec3f point,
                                   float max_distance = PointSearch::anywhere) const noexcept {
        return search_.nearest(point, max_distance);
    }

    /// The up to found.size() nearest points, in order. Returns how many there are.
    [[nodiscard]] std::size_t nearest_k(Vec3f point, std::span<Neighbor> found,
                                        float max_distance = PointSearch::anywhere) const noexcept {
        return search_.nearest_k(point, found, max_distance);
    }

    /// Calls `visit` with all points within a distance, in no particular order.
    void for_each_within(Vec3f center, float radius, Visitor<Neighbor> visit) const noexcept {
        search_.for_each_within(center, radius, visit);
    }

    /// Calls `visit` with the ids of all points in a box, in no particular order.
    void for_each_overlapping(const Aabb& box, Visitor<std::uint32_t> visit) const noexcept {
        search_.for_each_overlapping(box, visit);
    }

    /// Searches for many places at once.
    [[nodiscard]] const PointSearch& search() const noexcept { return search_; }

    /// The points, in the order they were given.
    [[nodiscard]] std::span<const Vec3f> points() const noexcept { return points_; }

    /// The tree over them.
    [[nodiscard]] const KdTree& tree() const noexcept { return search_.tree(); }

    /// How the tree was built and what it measures.
    [[nodiscard]] const BuildReport& build_report() const noexcept { return report_; }

private:
    std::vector<Vec3f> points_;
    BuildReport report_;
    PointSearch search_;
};

}  // namespace coppice::inline v0
