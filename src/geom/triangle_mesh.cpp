#include "coppice/geom/triangle_mesh.h"

namespace coppice {

Aabb bounds_of(std::span<const Vec3f> points) noexcept {
    Aabb box;
    for (const Vec3f& point : points) {
        box.grow(point);
    }
    return box;
}

}  // namespace coppice
