#pragma once

#include "coppice/geom/triangle_mesh.h"

#include "report/exhibits.h"

#include <cstddef>

namespace coppice::lab {

/// How much of a scene an outline may be.
struct OutlineLimits {
    std::size_t triangles = 300'000;  ///< meshes of more are drawn as points
    std::size_t points = 150'000;     ///< on the surface of such a mesh, or of a point cloud
};

/// A mesh as it is if it has few triangles, or as points spread over its surface: as many on equal
/// areas, shaded by the triangle's direction. A mesh without triangles is so many of its vertices,
/// evenly drawn.
[[nodiscard]] report::SceneOutline outline_of(const TriangleMesh& mesh,
                                              const OutlineLimits& limits = {});

}  // namespace coppice::lab
