#pragma once

#include "coppice/geom/triangle_mesh.h"
#include "coppice/query/neighbor.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace coppice::inline v0 {

/// The parts of a closed mesh that decide between inside and outside: its corners, welded by
/// position, with their pseudonormals, and the triangle across each edge.
class ClosedSurface {
public:
    /// Throws Error(unsupported) if the mesh is not closed; see SignedDistance.
    explicit ClosedSurface(TriangleMeshView mesh);

    /// True if a point is inside the surface. `nearest` must be the nearest triangle and its
    /// feature.
    [[nodiscard]] bool is_inside(Vec3f point, const SurfaceNeighbor& nearest) const noexcept;

private:
    struct EdgeSide;

    void weld(TriangleMeshView mesh);
    void connect();
    void connect_edge(const EdgeSide* first, const EdgeSide* last);
    void weigh_corners();
    [[nodiscard]] std::vector<EdgeSide> edge_sides() const;
    [[nodiscard]] Vec3d corner(std::uint32_t triangle, std::size_t at) const noexcept;
    [[nodiscard]] Vec3d unit_normal(std::uint32_t triangle) const noexcept;
    [[nodiscard]] Vec3d edge_normal(std::uint32_t triangle, std::size_t edge) const noexcept;
    [[nodiscard]] bool is_collapsed(std::uint32_t triangle) const noexcept;

    std::vector<Vec3f> corners_;
    std::vector<Vec3d> corner_normals_;  // angle-weighted
    std::vector<TriangleIndices> triangles_;
    std::vector<TriangleIndices> across_;  // the triangle across each edge; for a collapsed
                                           // triangle, one that is not and has the edge
    double outward_ = 1.0;                 // -1 if the mesh is inside out
};

}  // namespace coppice::inline v0
