#include "exhibits/scene_outline.h"

#include "scenes/surface_points.h"

#include <algorithm>
#include <utility>

namespace coppice::lab {

namespace {

report::SceneOutline some_vertices(std::span<const Vec3f> vertices, std::size_t most) {
    report::SceneOutline outline;
    const std::size_t count = std::min(vertices.size(), most);
    for (std::size_t i = 0; i < count; ++i) {
        outline.positions.push_back(vertices[i * vertices.size() / count]);
    }
    outline.shades.assign(count, 200);
    return outline;
}

}  // namespace

report::SceneOutline outline_of(const TriangleMesh& mesh, const OutlineLimits& limits) {
    if (!(total_area(mesh.view()) > 0.0)) return some_vertices(mesh.vertices, limits.points);
    if (mesh.triangles.size() > limits.triangles) {
        SurfacePoints points = surface_points(mesh.view(), limits.points);
        return {std::move(points.positions), {}, std::move(points.shades)};
    }
    return {mesh.vertices, mesh.triangles, {}};
}

}  // namespace coppice::lab
