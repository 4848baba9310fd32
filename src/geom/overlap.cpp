// Separating axis test of a triangle and a box. The axes are those of the box, the triangle's
// normal, and the nine cross products of their edges. Tests on the box's axes need comparisons only
// and are exact. On the other axes, a gap counts only if it exceeds the rounding error. The box is
// first cut to the bounding box of the triangle, so that no coordinate is infinite.
// Source: [AkenineMoller2001].

#include "coppice/geom/overlap.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace coppice::inline v0 {
namespace {

using Corners = std::array<Vec3d, 3>;  // relative to the box's center

double sum_of_products(Vec3d a, Vec3d b) noexcept {
    return std::abs(a.x * b.x) + std::abs(a.y * b.y) + std::abs(a.z * b.z);
}

// True if `axis` separates the triangle from the box. Each component of `axis` may have an error of
// a few rounding units of `scale`.
bool is_apart(const Corners& corners, Vec3d half, Vec3d axis, double scale) noexcept {
    double least = Aabb::infinity;
    double most = -Aabb::infinity;
    double reach = 0.0;
    for (const Vec3d& corner : corners) {
        const double along = dot(axis, corner);
        least = std::min(least, along);
        most = std::max(most, along);
        reach = std::max(reach, std::abs(corner.x) + std::abs(corner.y) + std::abs(corner.z));
    }
    const double radius =
        sum_of_products(axis, half) + 0x1.0p-49 * scale * (reach + half.x + half.y + half.z);
    return least > radius || most < -radius;
}

double largest_of(Vec3d v) noexcept {
    return std::max(std::abs(v.x), std::max(std::abs(v.y), std::abs(v.z)));
}

}  // namespace

bool overlaps(const Triangle& triangle, const Aabb& box) noexcept {
    const Aabb common = intersection(box, triangle_bounds(triangle));
    if (common.is_empty()) return false;
    for (const Vec3f& corner : triangle) {
        if (box.contains(corner)) return true;  // decides most overlapping cases early
    }
    const Vec3d lower = to_double(common.lower);
    const Vec3d upper = to_double(common.upper);
    const Vec3d center = 0.5 * (lower + upper);
    const Vec3d half = 0.5 * (upper - lower);
    Corners corners;
    Corners edges;
    for (std::size_t i = 0; i < 3; ++i) {
        corners[i] = to_double(triangle[i]) - center;
        edges[i] = to_double(triangle[(i + 1) % 3]) - to_double(triangle[i]);
    }
    const double first = largest_of(edges[0]);
    const double second = largest_of(edges[1]);
    if (is_apart(corners, half, cross(edges[0], edges[1]), 2.0 * first * second)) return false;
    for (const Vec3d& edge : edges) {
        const double scale = largest_of(edge);
        if (is_apart(corners, half, {0.0, -edge.z, edge.y}, scale)) return false;
        if (is_apart(corners, half, {edge.z, 0.0, -edge.x}, scale)) return false;
        if (is_apart(corners, half, {-edge.y, edge.x, 0.0}, scale)) return false;
    }
    return true;
}

}  // namespace coppice::inline v0
