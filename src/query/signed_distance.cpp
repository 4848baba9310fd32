#include "coppice/query/signed_distance.h"

#include "base/batch.h"
#include "base/out_of_memory.h"
#include "query/closed_surface.h"

#include <limits>
#include <utility>

namespace coppice::inline v0 {

SignedDistance::SignedDistance(TriangleMeshView mesh, MeshSearch search)
    : search_(std::move(search)), surface_(with_memory_errors("the signed distance", [&] {
          return std::make_shared<const ClosedSurface>(mesh);
      })) {}

SignedNeighbor SignedDistance::nearest(Vec3f point) const noexcept {
    const SurfaceNeighbor nearest = search_.nearest(point);
    if (!nearest.is_found()) return {std::numeric_limits<double>::quiet_NaN(), nearest};
    const double distance = nearest.distance();
    // Far away, rounding makes all triangles equally near, and the one found may face away from the
    // point. Hence the test against the bounding box: no point outside it is inside the surface.
    const bool is_negative = distance > 0.0 && search_.tree().bounds().contains(point) &&
                             surface_->is_inside(point, nearest);
    return {is_negative ? -distance : distance, nearest};
}

void SignedDistance::distances(std::span<const Vec3f> points, std::span<double> found,
                               int threads) const {
    require_room("distances", points.size(), found.size());
    for_each_query(points.size(), threads,
                   [&](std::size_t i) { found[i] = nearest(points[i]).signed_distance; });
}

}  // namespace coppice::inline v0
