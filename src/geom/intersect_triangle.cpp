// The watertight ray-triangle test. The triangle is sheared into a space where the ray is the z
// axis, and the signs of three edge functions decide. The original computes them in float, and in
// double where one is zero. Here they are computed in double with a bound on the rounding error.
// Where that bound leaves a sign open, edge_function() computes it exactly; that happens about once
// in a billion tests, unless rays are aimed at edges. So every sign is exact, hits are those of
// exact arithmetic, and no ray passes between triangles that share an edge.
//
// The distance loses too many digits where the ray is nearly parallel to the triangle's plane or
// starts close to it. It is then recomputed from the plane in double-double arithmetic.
// Source: [Woop2013] sec. 3.

#include "coppice/geom/triangle.h"

#include "geom/double_double.h"
#include "geom/edge_function.h"
#include "geom/triangle_error.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

namespace coppice::inline v0 {
namespace {

double edge_function(Vec3d a, Vec3d b) noexcept {
    return a.x * b.y - a.y * b.x;
}

// The larger absolute value of a corner's sheared x and y, its distance from the ray.
double aside(Vec3d corner) noexcept {
    return std::max(std::abs(corner.x), std::abs(corner.y));
}

// The index of the corner nearest to a point in the Manhattan distance.
std::size_t nearest_corner(Vec3d point, const Triangle& triangle) noexcept {
    std::array<double, 3> distance;
    for (std::size_t i = 0; i < 3; ++i) {
        const Vec3d from = to_double(triangle[i]) - point;
        distance[i] = std::abs(from.x) + std::abs(from.y) + std::abs(from.z);
    }
    return static_cast<std::size_t>(std::min_element(distance.begin(), distance.end()) -
                                    distance.begin());
}

// The distance at which a ray meets the plane of a triangle; infinity or NaN if it is parallel to
// the plane. Differences are taken from the nearest corner: seen from a corner 1e38 away, the other
// two would be rounded to one point.
double distance_to_plane(Vec3d origin, Vec3d direction, const Triangle& triangle) noexcept {
    const std::size_t nearest = nearest_corner(origin, triangle);
    const Vec3d a = to_double(triangle[nearest]);
    const Vec3<DoubleDouble> normal =
        cross(exact_difference(to_double(triangle[(nearest + 1) % 3]), a),
              exact_difference(to_double(triangle[(nearest + 2) % 3]), a));
    const DoubleDouble to_plane = dot(exact_difference(a, origin), normal);
    const DoubleDouble approach = dot(exact_difference(direction, {}), normal);
    return to_plane.high / approach.high;
}

Vec3f normal_of(const Triangle& triangle) noexcept {
    const Vec3d a = to_double(triangle[0]);
    return to_float(cross(to_double(triangle[1]) - a, to_double(triangle[2]) - a));
}

}  // namespace

TriangleTest::TriangleTest(const Ray& ray) noexcept
    : origin_(to_double(ray.origin)),
      direction_(to_double(ray.direction)),
      t_min_(ray.t_min),
      axes_(ray.direction) {
    const std::array<double, 3> direction{ray.direction.x, ray.direction.y, ray.direction.z};
    scale_z_ = 1.0 / direction[axes_.z];
    shear_x_ = direction[axes_.x] * scale_z_;
    shear_y_ = direction[axes_.y] * scale_z_;
}

Vec3d TriangleTest::to_frame(Vec3f corner) const noexcept {
    const std::array<double, 3> p{corner.x - origin_.x, corner.y - origin_.y, corner.z - origin_.z};
    const double z = p[axes_.z];
    return {p[axes_.x] - shear_x_ * z, p[axes_.y] - shear_y_ * z, z};
}

TriangleTest::Weights TriangleTest::precise_weights(const Triangle& triangle) const noexcept {
    const auto weight = [&](std::size_t from, std::size_t to) {
        return edge_function(origin_, direction_, to_double(triangle[from]),
                             to_double(triangle[to]));
    };
    return {scale_z_ * weight(2, 1), scale_z_ * weight(0, 2), scale_z_ * weight(1, 0)};
}

std::optional<Hit> TriangleTest::operator()(const Triangle& triangle, float t_max) const noexcept {
    const Corners corner{to_frame(triangle[0]), to_frame(triangle[1]), to_frame(triangle[2])};
    const auto& [a, b, c] = corner;
    Weights weight{edge_function(c, b), edge_function(a, c), edge_function(b, a)};
    const FrameExtent extent{std::max({aside(a), aside(b), aside(c)}),
                             std::max({std::abs(a.z), std::abs(b.z), std::abs(c.z)})};
    const double error = weight_error(extent);
    const auto least = [&] { return std::min({weight[0], weight[1], weight[2]}); };
    const auto most = [&] { return std::max({weight[0], weight[1], weight[2]}); };
    if (least() < -error && most() > error) return std::nullopt;
    if (!(least() > error || most() < -error)) {
        weight = precise_weights(triangle);
        if ((least() < 0.0) == (most() > 0.0)) return std::nullopt;  // outside, or in the plane
    }
    const auto t = static_cast<float>(distance(corner, weight, extent, triangle));
    // A hit beyond the range of float does not count, because its t cannot be represented.
    if (!(t >= t_min_ && t <= t_max && t <= std::numeric_limits<float>::max())) return std::nullopt;
    const double per_weight = 1.0 / (weight[0] + weight[1] + weight[2]);
    return Hit{t, static_cast<float>(weight[1] * per_weight),
               static_cast<float>(weight[2] * per_weight), 0, normal_of(triangle)};
}

double TriangleTest::distance(const Corners& corner, const Weights& weight, FrameExtent extent,
                              const Triangle& triangle) const noexcept {
    const auto& [a, b, c] = corner;
    const double sum = weight[0] + weight[1] + weight[2];
    const double z = (weight[0] * a.z + weight[1] * b.z + weight[2] * c.z) / sum;
    const double lowest = std::min({a.z, b.z, c.z});
    const double highest = std::max({a.z, b.z, c.z});
    if (is_precise(z, sum, highest - lowest, extent)) return z * scale_z_;
    const double precise = distance_to_plane(origin_, direction_, triangle);
    if (!std::isfinite(precise)) return z * scale_z_;
    const auto [nearest, farthest] = std::minmax({lowest * scale_z_, highest * scale_z_});
    return std::clamp(precise, nearest, farthest);
}

std::optional<Hit> intersect_triangle(const Ray& ray, const Triangle& triangle) noexcept {
    if (!is_traceable(ray)) return std::nullopt;
    return TriangleTest(ray)(triangle, ray.t_max);
}

}  // namespace coppice::inline v0
