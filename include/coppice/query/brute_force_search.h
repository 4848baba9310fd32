#pragma once

#include "coppice/export.h"
#include "coppice/geom/aabb.h"
#include "coppice/geom/point_cloud.h"
#include "coppice/geom/triangle_mesh.h"
#include "coppice/query/neighbor.h"

#include <cstdint>
#include <limits>
#include <vector>

namespace coppice::inline v0 {

/// All triangles within a distance of a point, in order of distance, equally near ones in order of
/// id. Tests every triangle: the reference for tests of MeshSearch.
[[nodiscard]] COPPICE_EXPORT std::vector<SurfaceNeighbor> brute_force_within(
    TriangleMeshView mesh, Vec3f center, float radius = std::numeric_limits<float>::infinity());

/// All points within a distance of a point, in the same order. Tests every point: the reference for
/// tests of PointSearch.
[[nodiscard]] COPPICE_EXPORT std::vector<Neighbor> brute_force_within(
    PointCloudView points, Vec3f center, float radius = std::numeric_limits<float>::infinity());

/// The ids of all triangles that overlap a closed box, ascending. Tests every triangle.
[[nodiscard]] COPPICE_EXPORT std::vector<std::uint32_t> brute_force_overlapping(
    TriangleMeshView mesh, const Aabb& box);

/// The ids of all points in a closed box, ascending. Tests every point.
[[nodiscard]] COPPICE_EXPORT std::vector<std::uint32_t> brute_force_overlapping(
    PointCloudView points, const Aabb& box);

}  // namespace coppice::inline v0
