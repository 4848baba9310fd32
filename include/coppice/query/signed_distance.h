#pragma once

#include "coppice/export.h"
#include "coppice/geom/triangle_mesh.h"
#include "coppice/query/mesh_search.h"
#include "coppice/query/neighbor.h"

#include <cstdint>
#include <memory>
#include <span>

namespace coppice::inline v0 {

class ClosedSurface;

/// The nearest triangle, and the distance to it with a sign.
struct SignedNeighbor {
    double signed_distance = 0.0;  ///< negative inside; NaN if nothing was found
    SurfaceNeighbor nearest;       ///< the triangle that the distance is measured to
};

/// Distances to the surface of a closed mesh, negative inside.
///
/// A mesh is closed if every edge is shared by exactly two triangles that run along it in opposite
/// directions; corners at the same position are one, and triangles with two of their corners at the
/// same position do not count. Parts may lie in each other, as hollows do, but must not cut each
/// other. If the mesh encloses a negative volume, it is taken to be inside out.
///
/// Robust on edges and corners, where signs are those of angle-weighted pseudonormals. Triangles
/// with area 0 and three different corners are allowed, but the sign at points nearest to one of
/// them is not certain. Source: [Baerentzen2005].
class COPPICE_EXPORT SignedDistance {
public:
    /// `search` is over the triangles of `mesh`, which need not outlive the call. O(N log N), 42
    /// bytes a triangle. Throws Error(unsupported) naming the first edge if the mesh is not closed,
    /// and if it has no triangles; Error(invalid_argument) for an index that no vertex has.
    SignedDistance(TriangleMeshView mesh, MeshSearch search);

    /// The nearest triangle of a point with the signed distance to it. Nothing is found for a point
    /// that is not finite. Reentrant, allocates nothing.
    [[nodiscard]] SignedNeighbor nearest(Vec3f point) const noexcept;

    /// The signed distances of many points, on at most `threads` threads (0 = all). Throws
    /// Error(invalid_argument) if the spans differ in length, and for negative `threads`.
    void distances(std::span<const Vec3f> points, std::span<double> found, int threads = 0) const;

private:
    MeshSearch search_;
    std::shared_ptr<const ClosedSurface> surface_;
};

}  // namespace coppice::inline v0
