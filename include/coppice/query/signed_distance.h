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

/// The nearest triangle of a point, and the signed distance to it.
struct SignedNeighbor {
    double signed_distance = 0.0;  ///< negative inside; NaN if nothing was found
    SurfaceNeighbor nearest;       ///< the triangle that the distance is measured to
};

/// Signed distances to the surface of a closed mesh, negative inside.
///
/// A mesh is closed if every edge is shared by exactly two triangles that traverse it in opposite
/// directions. Corners at the same position count as one corner. Triangles with two corners at the
/// same position are ignored. Parts may be nested, as cavities are, but must not intersect. If the
/// mesh encloses a negative volume, it is taken to be inside out, and signs are flipped.
///
/// On edges and corners, signs follow the angle-weighted pseudonormals. Triangles of area 0 with
/// three different corners are allowed, but the sign is unreliable at points whose nearest triangle
/// is one of them.
/// Source: [Baerentzen2005].
class COPPICE_EXPORT SignedDistance {
public:
    /// Prepares a mesh. `search` must be over the triangles of `mesh`; the arrays behind `mesh`
    /// need not outlive the call. O(N log N) time, 42 bytes a triangle. Throws Error(unsupported)
    /// if the mesh is not closed, naming the first edge at fault, or has no triangles. Throws
    /// Error(invalid_argument) for a vertex index out of range.
    SignedDistance(TriangleMeshView mesh, MeshSearch search);

    /// The nearest triangle of a point and the signed distance to it. For a point that is not
    /// finite, the distance is NaN. Reentrant; allocates nothing.
    [[nodiscard]] SignedNeighbor nearest(Vec3f point) const noexcept;

    /// Writes the signed distance of points[i] to found[i], on at most `threads` threads (0 = all
    /// hardware threads). Throws Error(invalid_argument) if the spans differ in length or `threads`
    /// is negative.
    void distances(std::span<const Vec3f> points, std::span<double> found, int threads = 0) const;

private:
    MeshSearch search_;
    std::shared_ptr<const ClosedSurface> surface_;
};

}  // namespace coppice::inline v0
