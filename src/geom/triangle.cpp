#include "coppice/geom/triangle.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <utility>

namespace coppice::inline v0 {
namespace {

using Corner = std::array<double, 3>;

// A convex polygon. It has the triangle's three corners, and each of the six clip planes adds at
// most one more.
struct Polygon {
    std::array<Corner, 9> corners;
    std::size_t count = 0;
};

constexpr Corner corner_at(const Vec3f& v) noexcept {
    return {v.x, v.y, v.z};
}

// The depth of a corner inside the half-space below (sign 1) or above (sign -1) a position on an
// axis; negative outside.
template <std::size_t axis, int sign>
double depth_of(const Corner& corner, double position) noexcept {
    return sign > 0 ? position - corner[axis] : corner[axis] - position;
}

// Clips a polygon to such a half-space: one step of Sutherland-Hodgman.
template <std::size_t axis, int sign>
void clip(const Polygon& polygon, double position, Polygon& inside) noexcept {
    inside.count = 0;
    if (polygon.count == 0) return;
    const Corner* from = polygon.corners.data();
    const Corner* const last = from + polygon.count - 1;
    double from_depth = depth_of<axis, sign>(*from, position);
    for (;; ++from) {
        const Corner& to = from == last ? polygon.corners[0] : from[1];
        const double to_depth = depth_of<axis, sign>(to, position);
        if (from_depth >= 0.0) inside.corners[inside.count++] = *from;
        const bool crosses = (from_depth >= 0.0) != (to_depth >= 0.0);
        if (crosses && inside.count < inside.corners.size()) {
            const double s = from_depth / (from_depth - to_depth);
            Corner& crossing = inside.corners[inside.count++];
            for (std::size_t i = 0; i < 3; ++i) {
                crossing[i] = (*from)[i] + s * (to[i] - (*from)[i]);
            }
            crossing[axis] = position;
        }
        if (from == last) return;
        from_depth = to_depth;
    }
}

// The next float below `x`, which must be finite.
float float_before(float x) noexcept {
    if (x == 0.0F) return -std::numeric_limits<float>::denorm_min();
    const auto bits = std::bit_cast<std::uint32_t>(x);
    return std::bit_cast<float>(x > 0.0F ? bits - 1 : bits + 1);
}

float round_down(double x) noexcept {
    const auto nearest = static_cast<float>(x);
    return nearest > x ? float_before(nearest) : nearest;
}

float round_up(double x) noexcept {
    return -round_down(-x);
}

// An upper bound of the rounding error of all clip steps, per axis. Each crossing has an error of a
// few units in the last place of the largest coordinate, and at most six crossings follow one
// another.
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

// The bounding box of a clipped polygon within `limits`, rounded outward to be conservative. The
// box stays flat on an axis where the triangle itself is flat.
Aabb rounded_bounds(const Polygon& polygon, const Vec3d& error, const Aabb& limits) noexcept {
    Corner lower = polygon.corners[0];
    Corner upper = lower;
    for (std::size_t i = 1; i < polygon.count; ++i) {
        for (std::size_t axis = 0; axis < 3; ++axis) {
            lower[axis] = std::min(lower[axis], polygon.corners[i][axis]);
            upper[axis] = std::max(upper[axis], polygon.corners[i][axis]);
        }
    }
    Aabb box;
    for (const Axis axis : all_axes) {
        const auto index = static_cast<std::size_t>(axis);
        const float least = limits.lower[axis];
        const float most = limits.upper[axis];
        // The order of arguments matters: if a corner is NaN, the result is the limit.
        box.lower[axis] = std::min(most, std::max(least, round_down(lower[index] - error[axis])));
        box.upper[axis] = std::max(least, std::min(most, round_up(upper[index] + error[axis])));
    }
    return box;
}

// Clips a polygon axis by axis to those faces of a box that cross the polygon's bounding box.
class Clipper {
public:
    explicit Clipper(const Triangle& triangle) noexcept {
        for (const Vec3f& corner : triangle) {
            polygon_->corners[polygon_->count++] = corner_at(corner);
        }
    }

    template <std::size_t index>
    void clip_axis(const Aabb& bounds, const Aabb& box, const Vec3d& error) noexcept {
        constexpr auto axis = static_cast<Axis>(index);
        if (bounds.lower[axis] < box.lower[axis]) {
            clip<index, -1>(*polygon_, box.lower[axis] - error[axis], *clipped_);
            std::swap(polygon_, clipped_);
        }
        if (bounds.upper[axis] > box.upper[axis]) {
            clip<index, 1>(*polygon_, box.upper[axis] + error[axis], *clipped_);
            std::swap(polygon_, clipped_);
        }
    }

    [[nodiscard]] const Polygon& polygon() const noexcept { return *polygon_; }

private:
    std::array<Polygon, 2> buffers_;
    Polygon* polygon_ = buffers_.data();
    Polygon* clipped_ = buffers_.data() + 1;
};

}  // namespace

Aabb triangle_bounds(const Triangle& triangle) noexcept {
    Aabb box;
    for (const Vec3f& corner : triangle) {
        box.grow(corner);
    }
    return box;
}

Aabb triangle_bounds_or_nan(const Triangle& triangle) noexcept {
    float sum = 0.0F;  // of zeros and NaN only
    for (const Vec3f& corner : triangle) {
        sum += 0.0F * corner.x + 0.0F * corner.y + 0.0F * corner.z;
    }
    if (!std::isnan(sum)) return triangle_bounds(triangle);
    return {{sum, sum, sum}, {sum, sum, sum}};
}

double triangle_area(const Triangle& triangle) noexcept {
    const Vec3d a = to_double(triangle[0]);
    const Vec3d b = to_double(triangle[1]);
    const Vec3d c = to_double(triangle[2]);
    // Uses the two shorter edges: the longest one may cancel the digits of another.
    std::array<Vec3d, 3> edges{b - a, c - b, a - c};
    std::swap(edges[2], *std::max_element(edges.begin(), edges.end(),
                                          [](const Vec3d& first, const Vec3d& second) {
                                              return dot(first, first) < dot(second, second);
                                          }));
    const Vec3d normal = cross(edges[0], edges[1]);
    return 0.5 * std::sqrt(dot(normal, normal));
}

Aabb clipped_triangle_bounds(const Triangle& triangle, const Aabb& box) noexcept {
    const Aabb bounds = triangle_bounds(triangle);
    if (is_inside(bounds, box)) return bounds;
    const Aabb limits = intersection(bounds, box);
    if (limits.is_empty()) return {};

    const Vec3d error = clip_error(bounds);
    Clipper clipper(triangle);
    clipper.clip_axis<0>(bounds, box, error);
    clipper.clip_axis<1>(bounds, box, error);
    clipper.clip_axis<2>(bounds, box, error);
    return clipper.polygon().count == 0 ? Aabb{} : rounded_bounds(clipper.polygon(), error, limits);
}

}  // namespace coppice::inline v0
