#include "coppice/geom/triangle_mesh.h"

#include "coppice/base/error.h"

#include "geom/require_ids.h"

#include <algorithm>
#include <string>

namespace coppice::inline v0 {

TriangleMeshView::TriangleMeshView(std::span<const Vec3f> vertices,
                                   std::span<const TriangleIndices> triangles)
    : vertices_(vertices), triangles_(triangles) {
    require_ids(triangles.size(), "triangles");
}

std::uint32_t TriangleMeshView::first_invalid(std::uint32_t first,
                                              std::uint32_t last) const noexcept {
    // Two passes: the first has no branches; the second runs only for an invalid mesh.
    std::uint32_t highest = 0;
    for (std::uint32_t id = first; id < last; ++id) {
        const TriangleIndices& corner = triangles_[id];
        highest = std::max(highest, std::max(std::max(corner[0], corner[1]), corner[2]));
    }
    if (first == last || highest < vertices_.size()) return last;
    const auto is_invalid = [&](const TriangleIndices& corner) {
        return std::any_of(corner.begin(), corner.end(),
                           [&](std::uint32_t index) { return index >= vertices_.size(); });
    };
    while (!is_invalid(triangles_[first])) {
        ++first;
    }
    return first;
}

void TriangleMeshView::require_valid(std::uint32_t first, std::uint32_t last) const {
    const std::uint32_t id = first_invalid(first, last);
    if (id == last) return;
    const TriangleIndices& corner = triangles_[id];
    const auto index = *std::find_if(corner.begin(), corner.end(),
                                     [&](std::uint32_t i) { return i >= vertices_.size(); });
    throw Error(ErrorCode::invalid_argument, "triangle " + std::to_string(id) +
                                                 " has the vertex index " + std::to_string(index) +
                                                 ", but there are " +
                                                 std::to_string(vertices_.size()) + " vertices");
}

Aabb bounds_of(std::span<const Vec3f> points) noexcept {
    Aabb box;
    for (const Vec3f& point : points) {
        box.grow(point);
    }
    return box;
}

}  // namespace coppice::inline v0
