#include "coppice/geom/triangle.h"

#include <algorithm>
#include <cmath>

namespace coppice {
namespace {

// A convex polygon: three corners, and at most one more for each of the six clip planes.
struct Polygon {
    std::array<Vec3d, 9> corners;
    std::size_t count = 0;

    void add(Vec3d corner) noexcept { corners[count++] = corner; }
};

// The part of a polygon with sign * p[axis] <= sign * position (Sutherland-Hodgman, one plane).
Polygon clip(const Polygon& polygon, Axis axis, double position, double sign) noexcept {
    Polygon inside;
    for (std::size_t i = 0; i < polygon.count; ++i) {
        const Vec3d& from = polygon.corners[i];
        const Vec3d& to = polygon.corners[i + 1 == polygon.count ? 0 : i + 1];
        const double from_distance = sign * (position - from[axis]);
        const double to_distance = sign * (position - to[axis]);
        if (from_distance >= 0.0) inside.add(from);
        if ((from_distance >= 0.0) != (to_distance >= 0.0)) {
            const double s = from_distance / (from_distance - to_distance);
            Vec3d crossing = from + s * (to - from);
            crossing[axis] = position;
            if (inside.count < inside.corners.size()) inside.add(crossing);
        }
    }
    return inside;
}

float round_down(double x) noexcept {
    const auto nearest = static_cast<float>(x);
    return nearest > x ? std::nextafter(nearest, -Aabb::infinity) : nearest;
}

float round_up(double x) noexcept {
    const auto nearest = static_cast<float>(x);
    return nearest < x ? std::nextafter(nearest, Aabb::infinity) : nearest;
}

// An upper bound of the rounding error of all clip steps, per axis: each crossing is off by a few
// units in the last place of the largest coordinate, and there are at most six in a row.
Vec3d clip_error(const Aabb& bounds) noexcept {
    Vec3d error;
    for (const Axis axis : all_axes) {
        error[axis] = 0x1.0p-46 * std::max(std::abs(static_cast<double>(bounds.lower[axis])),
                                           std::abs(static_cast<double>(bounds.upper[axis])));
    }
    return error;
}

bool is_inside(const Aabb& inner, const Aabb& outer) noexcept {
    return std::all_of(all_axes.begin(), all_axes.end(), [&](Axis axis) {
        return inner.lower[axis] >= outer.lower[axis] && inner.upper[axis] <= outer.upper[axis];
    });
}

// The rounded box of a clipped polygon, within `limits`: so that it is conservative and yet as
// flat as the triangle itself where that lies in an axis-parallel plane.
Aabb rounded_bounds(const Polygon& polygon, const Vec3d& error, const Aabb& limits) noexcept {
    Aabb box;
    for (const Axis axis : all_axes) {
        double lower = polygon.corners[0][axis];
        double upper = lower;
        for (std::size_t i = 1; i < polygon.count; ++i) {
            lower = std::min(lower, polygon.corners[i][axis]);
            upper = std::max(upper, polygon.corners[i][axis]);
        }
        const float least = limits.lower[axis];
        const float most = limits.upper[axis];
        // In this order a corner that is NaN gives the limits.
        box.lower[axis] = std::min(most, std::max(least, round_down(lower - error[axis])));
        box.upper[axis] = std::max(least, std::min(most, round_up(upper + error[axis])));
    }
    return box;
}

}  // namespace

Aabb triangle_bounds(const Triangle& triangle) noexcept {
    Aabb box;
    for (const Vec3f& corner : triangle)
        box.grow(corner);
    return box;
}

double triangle_area(const Triangle& triangle) noexcept {
    const Vec3d a = to_double(triangle[0]);
    const Vec3d normal = cross(to_double(triangle[1]) - a, to_double(triangle[2]) - a);
    return 0.5 * std::sqrt(dot(normal, normal));
}

Aabb clipped_triangle_bounds(const Triangle& triangle, const Aabb& box) noexcept {
    const Aabb bounds = triangle_bounds(triangle);
    if (is_inside(bounds, box)) return bounds;
    const Aabb limits = intersection(bounds, box);
    if (limits.is_empty()) return {};

    const Vec3d error = clip_error(bounds);
    Polygon polygon;
    for (const Vec3f& corner : triangle)
        polygon.add(to_double(corner));
    for (const Axis axis : all_axes) {
        if (bounds.lower[axis] < box.lower[axis]) {
            polygon = clip(polygon, axis, box.lower[axis] - error[axis], -1.0);
        }
        if (bounds.upper[axis] > box.upper[axis]) {
            polygon = clip(polygon, axis, box.upper[axis] + error[axis], 1.0);
        }
    }
    return polygon.count == 0 ? Aabb{} : rounded_bounds(polygon, error, limits);
}

}  // namespace coppice
