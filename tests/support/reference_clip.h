#pragma once

#include "coppice/geom/aabb.h"
#include "coppice/geom/triangle.h"

#include <algorithm>
#include <limits>
#include <vector>

namespace coppice::test {

/// A box in extended precision.
struct Bvh8Box {
    static constexpr long double infinity = std::numeric_limits<long double>::infinity();

    Vec3<long double> lower{infinity, infinity, infinity};
    Vec3<long double> upper{-infinity, -infinity, -infinity};

    [[nodiscard]] bool is_empty() const noexcept { return lower.x > upper.x; }

    [[nodiscard]] Bvh8Box grown(Vec3<long double> by) const noexcept {
        return {lower - by, upper + by};
    }
};

[[nodiscard]] inline Bvh8Box to_bvh8(const Aabb& box) noexcept {
    return {{box.lower.x, box.lower.y, box.lower.z}, {box.upper.x, box.upper.y, box.upper.z}};
}

/// The box of a triangle's part inside `box`: written apart from the library's, in extended
/// precision, corner by corner and face by face. Off by some 2^-60 of the coordinates.
[[nodiscard]] inline Bvh8Box reference_clip(const Triangle& triangle, const Bvh8Box& box) {
    using Point = Vec3<long double>;
    std::vector<Point> polygon;
    for (const Vec3f& corner : triangle) {
        polygon.push_back({corner.x, corner.y, corner.z});
    }
    const auto keep = [&](Axis axis, long double limit, bool keep_lower) {
        const auto is_kept = [&](const Point& p) {
            return keep_lower ? p[axis] <= limit : p[axis] >= limit;
        };
        std::vector<Point> kept;
        for (std::size_t i = 0; i < polygon.size(); ++i) {
            const Point& a = polygon[i];
            const Point& b = polygon[(i + 1) % polygon.size()];
            if (is_kept(a)) kept.push_back(a);
            if (is_kept(a) == is_kept(b)) continue;
            Point crossing = a + ((limit - a[axis]) / (b[axis] - a[axis])) * (b - a);
            crossing[axis] = limit;
            kept.push_back(crossing);
        }
        polygon = std::move(kept);
    };
    for (const Axis axis : all_axes) {
        keep(axis, box.upper[axis], true);
        keep(axis, box.lower[axis], false);
    }
    Bvh8Box bounds;
    for (const Point& p : polygon) {
        for (const Axis axis : all_axes) {
            bounds.lower[axis] = std::min(bounds.lower[axis], p[axis]);
            bounds.upper[axis] = std::max(bounds.upper[axis], p[axis]);
        }
    }
    return bounds;
}

}  // namespace coppice::test
