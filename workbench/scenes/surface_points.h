#pragma once

#include "coppice/geom/triangle_mesh.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace coppice::lab {

/// Points on a surface.
struct SurfacePoints {
    std::vector<Vec3f> positions;
    std::vector<std::uint8_t> shades;  ///< of each: how bright its triangle is, by its direction
};

/// The area of all triangles together.
[[nodiscard]] double total_area(TriangleMeshView mesh);

/// `count` points spread over a mesh's surface, as many on equal areas, with their shades. None if
/// it has no area.
[[nodiscard]] SurfacePoints surface_points(TriangleMeshView mesh, std::size_t count);

}  // namespace coppice::lab
