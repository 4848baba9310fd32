// A scene in as few numbers as show its shape. Points are drawn on the surface and not taken from
// the vertices: a wall of two triangles is as well covered as a statue of a million. They stand at
// equal distances along the running sum of the triangles' areas, which spreads them more evenly
// than chance would. Cost O(triangles + points). Source: [Pharr2016] sec. 13.6.5 (points of a
// triangle).

#include "lab/scene_outline.h"

#include "coppice/base/rng.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace coppice::lab {

namespace {

constexpr std::uint64_t seed = 1;

/// How bright a surface is that faces `normal`, either side: lit from above, the side and the front
/// in different strength, so that edges show from everywhere.
std::uint8_t shade_of(Vec3d normal) {
    const double size = std::sqrt(dot(normal, normal));
    if (!(size > 0.0)) return 128;
    const double light =
        0.35 +
        (0.6 * std::abs(normal.y) + 0.35 * std::abs(normal.z) + 0.1 * std::abs(normal.x)) / size;
    return static_cast<std::uint8_t>(std::lround(255.0 * std::min(light, 1.0)));
}

/// A point of a triangle, uniform in u and v in [0, 1).
Vec3f point_on(const Triangle& triangle, double u, double v) {
    const double root = std::sqrt(u);
    return to_float((1.0 - root) * to_double(triangle[0]) +
                    root * (1.0 - v) * to_double(triangle[1]) + root * v * to_double(triangle[2]));
}

double total_area(TriangleMeshView mesh) {
    double area = 0.0;
    for (std::uint32_t id = 0; id < mesh.size(); ++id) {
        area += triangle_area(mesh.triangle(id));
    }
    return area;
}

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

report::SceneOutline surface_points(TriangleMeshView mesh, std::size_t count) {
    report::SceneOutline outline;
    const double area = total_area(mesh);
    if (!(area > 0.0)) return outline;
    outline.positions.reserve(count);
    outline.shades.reserve(count);
    const double step = area / static_cast<double>(count);
    double before = 0.0;  // the area of the triangles so far
    for (std::uint32_t id = 0; id < mesh.size(); ++id) {
        const Triangle triangle = mesh.triangle(id);
        before += triangle_area(triangle);
        while (outline.positions.size() < count &&
               (static_cast<double>(outline.positions.size()) + 0.5) * step <= before) {
            const std::uint64_t i = outline.positions.size();
            outline.positions.push_back(
                point_on(triangle, random_unit(seed, 2 * i), random_unit(seed, 2 * i + 1)));
            const Vec3d a = to_double(triangle[0]);
            outline.shades.push_back(
                shade_of(cross(to_double(triangle[1]) - a, to_double(triangle[2]) - a)));
        }
    }
    return outline;
}

report::SceneOutline outline_of(const TriangleMesh& mesh, const OutlineLimits& limits) {
    if (!(total_area(mesh.view()) > 0.0)) return some_vertices(mesh.vertices, limits.points);
    if (mesh.triangles.size() > limits.triangles) {
        return surface_points(mesh.view(), limits.points);
    }
    return {mesh.vertices, mesh.triangles, {}};
}

}  // namespace coppice::lab
