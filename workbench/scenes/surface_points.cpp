// Points are drawn on the surface, not taken from the vertices: a wall of two triangles is covered
// as well as a statue of a million. They stand at equal distances along the running sum of the
// triangles' areas, which spreads them more evenly than independent draws. Cost: O(triangles +
// points). Source: [Pharr2016] sec. 13.6.5 (points of a triangle).

#include "scenes/surface_points.h"

#include "coppice/base/rng.h"

#include <algorithm>
#include <cmath>

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

}  // namespace

double total_area(TriangleMeshView mesh) {
    double area = 0.0;
    for (std::uint32_t id = 0; id < mesh.size(); ++id) {
        area += triangle_area(mesh.triangle(id));
    }
    return area;
}

SurfacePoints surface_points(TriangleMeshView mesh, std::size_t count) {
    SurfacePoints points;
    const double area = total_area(mesh);
    if (!(area > 0.0)) return points;
    points.positions.reserve(count);
    points.shades.reserve(count);
    const double step = area / static_cast<double>(count);
    double before = 0.0;  // the area of the triangles so far
    for (std::uint32_t id = 0; id < mesh.size(); ++id) {
        const Triangle triangle = mesh.triangle(id);
        before += triangle_area(triangle);
        while (points.positions.size() < count &&
               (static_cast<double>(points.positions.size()) + 0.5) * step <= before) {
            const std::uint64_t i = points.positions.size();
            points.positions.push_back(
                point_on(triangle, random_unit(seed, 2 * i), random_unit(seed, 2 * i + 1)));
            const Vec3d a = to_double(triangle[0]);
            points.shades.push_back(
                shade_of(cross(to_double(triangle[1]) - a, to_double(triangle[2]) - a)));
        }
    }
    return points;
}

}  // namespace coppice::lab
