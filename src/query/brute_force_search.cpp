#include "coppice/query/brute_force_search.h"

#include "coppice/geom/overlap.h"

#include "query/distance.h"
#include "query/limit.h"

#include <algorithm>

namespace coppice::inline v0 {
namespace {

template <typename Found>
std::vector<Found> sorted(std::vector<Found> found) {
    std::stable_sort(found.begin(), found.end(), [](const Found& a, const Found& b) {
        return a.distance_squared < b.distance_squared;
    });
    return found;
}

}  // namespace

std::vector<SurfaceNeighbor> brute_force_within(TriangleMeshView mesh, Vec3f center, float radius) {
    std::vector<SurfaceNeighbor> found;
    if (!is_searchable(center, radius)) return found;
    for (std::uint32_t id = 0; id < mesh.size(); ++id) {
        const ClosestPoint at = closest_point(mesh.triangle(id), center);
        if (at.distance_squared > squared(radius)) continue;
        found.push_back({at.distance_squared, at.point, at.u, at.v, id, at.feature});
    }
    return sorted(std::move(found));
}

std::vector<Neighbor> brute_force_within(PointCloudView points, Vec3f center, float radius) {
    std::vector<Neighbor> found;
    if (!is_searchable(center, radius)) return found;
    for (std::uint32_t id = 0; id < points.size(); ++id) {
        const double distance = distance_squared(points.points()[id], center);
        if (distance <= squared(radius)) found.push_back({distance, id});
    }
    return sorted(std::move(found));
}

std::vector<std::uint32_t> brute_force_overlapping(TriangleMeshView mesh, const Aabb& box) {
    std::vector<std::uint32_t> found;
    for (std::uint32_t id = 0; id < mesh.size(); ++id) {
        if (overlaps(mesh.triangle(id), box)) found.push_back(id);
    }
    return found;
}

std::vector<std::uint32_t> brute_force_overlapping(PointCloudView points, const Aabb& box) {
    std::vector<std::uint32_t> found;
    for (std::uint32_t id = 0; id < points.size(); ++id) {
        if (box.contains(points.points()[id])) found.push_back(id);
    }
    return found;
}

}  // namespace coppice::inline v0
