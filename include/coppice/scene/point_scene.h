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

/// Points and the k-d tree for searching them. Queries are reentrant.
class COPPICE_EXPORT PointScene {
public:
    /// The options with the fastest searches: the thesis's tree of points without refinement, from
    /// a sample of one in 32, split at midpoints.
    [[nodiscard]] static KdOptions search_options();

    /// Takes the points and builds their tree with search_options(). If that leaves many points in
    /// one leaf, because other points are very far away, the tree is rebuilt with median splits.
    /// Throws Error as build_kd_tree() does.
    explicit PointScene(std::vector<Vec3f> points);

    /// Takes the points and builds their tree with other options.
    PointScene(std::vector<Vec3f> points, const KdOptions& options);

    /// The point nearest to `point`; see PointSearch::nearest(). If none is within `max_distance`,
    /// the result's is_found() is false.
    [[nodiscard]] Neighbor nearest(Vec3f point,
                                   float max_distance = PointSearch::anywhere) const noexcept {
        return search_.nearest(point, max_distance);
    }

    /// Writes the nearest points to the front of `found` in order, at most found.size() of them.
    /// Returns their number.
    [[nodiscard]] std::size_t nearest_k(Vec3f point, std::span<Neighbor> found,
                                        float max_distance = PointSearch::anywhere) const noexcept {
        return search_.nearest_k(point, found, max_distance);
    }

    /// Calls `visit` for every point within a distance, in no particular order.
    void for_each_within(Vec3f center, float radius, Visitor<Neighbor> visit) const noexcept {
        search_.for_each_within(center, radius, visit);
    }

    /// Calls `visit` with the id of every point in a closed box, in no particular order.
    void for_each_overlapping(const Aabb& box, Visitor<std::uint32_t> visit) const noexcept {
        search_.for_each_overlapping(box, visit);
    }

    /// The search structure, which also has batched queries.
    [[nodiscard]] const PointSearch& search() const noexcept { return search_; }

    /// The points in the order in which they were passed.
    [[nodiscard]] std::span<const Vec3f> points() const noexcept { return points_; }

    /// The tree over the points.
    [[nodiscard]] const KdTree& tree() const noexcept { return search_.tree(); }

    /// The report of the tree's build, with its statistics.
    [[nodiscard]] const BuildReport& build_report() const noexcept { return report_; }

private:
    std::vector<Vec3f> points_;
    BuildReport report_;
    PointSearch search_;
};

}  // namespace coppice::inline v0
