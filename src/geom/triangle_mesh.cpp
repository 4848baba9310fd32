#include "coppice/geom/triangle_mesh.h"

#include "geom/require_ids.h"

namespace coppice::inline v0 {

TriangleMeshView::TriangleMeshView(std::span<const Vec3f> vertices,
                                   std::span<const TriangleIndices> triangles)
    : vertices_(vertices), triangles_(triangles) {
    require_ids(triangles.size(), "triangles");
}

Aabb bounds_of(std::span<const Vec3f> points) noexcept {
    Aabb box;
    for (const Vec3f& point : points) {
        box.grow(point);
    }
    return box;
}

}  // namespace coppice::inline v0
