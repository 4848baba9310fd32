// The watertight ray-triangle test: the triangle is sheared into a space where the ray is the z
// axis, and three edge functions decide. Two triangles evaluate a shared edge from the same
// numbers with opposite sign, so that a ray between them cannot miss both. The original falls back
// to double where float gives zero; here all is double, which float input makes nearly exact.
// Source: [Woop2013] sec. 3.

#include "coppice/geom/triangle.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace coppice {
namespace {

// a.x * b.y - a.y * b.x; where the products cancel, with their rounding errors. Else a ray in the
// plane of a sliver, or of a degenerate triangle, would find weights of nothing but noise: zeros
// that stand for any sign, and so hits far from the ray.
double edge_function(Vec3d a, Vec3d b) noexcept {
    const double first = a.x * b.y;
    const double second = a.y * b.x;
    const double difference = first - second;
    if (!(std::abs(difference) < 0x1.0p-26 * (std::abs(first) + std::abs(second)))) {
        return difference;
    }
    return difference + (std::fma(a.x, b.y, -first) - std::fma(a.y, b.x, -second));
}

Vec3f normal_of(const Triangle& triangle) noexcept {
    const Vec3d a = to_double(triangle[0]);
    return to_float(cross(to_double(triangle[1]) - a, to_double(triangle[2]) - a));
}

}  // namespace

TriangleTest::TriangleTest(const Ray& ray) noexcept
    : origin_(to_double(ray.origin)), t_min_(ray.t_min), axes_(ray.direction) {
    const std::array<double, 3> direction{ray.direction.x, ray.direction.y, ray.direction.z};
    scale_z_ = 1.0 / direction[axes_.z];
    shear_x_ = direction[axes_.x] * scale_z_;
    shear_y_ = direction[axes_.y] * scale_z_;
}

Vec3d TriangleTest::to_frame(Vec3f corner) const noexcept {
    const std::array<double, 3> p{corner.x - origin_.x, corner.y - origin_.y, corner.z - origin_.z};
    const double z = p[axes_.z];
    return {p[axes_.x] - shear_x_ * z, p[axes_.y] - shear_y_ * z, scale_z_ * z};
}

std::optional<Hit> TriangleTest::operator()(const Triangle& triangle, float t_max) const noexcept {
    const Vec3d a = to_frame(triangle[0]);
    const Vec3d b = to_frame(triangle[1]);
    const Vec3d c = to_frame(triangle[2]);
    const double weight_a = edge_function(c, b);
    const double weight_b = edge_function(a, c);
    const double weight_c = edge_function(b, a);
    const double least = std::min(weight_a, std::min(weight_b, weight_c));
    const double most = std::max(weight_a, std::max(weight_b, weight_c));
    if ((least < 0.0) == (most > 0.0)) return std::nullopt;  // outside, or edge-on

    const double per_weight = 1.0 / (weight_a + weight_b + weight_c);
    const auto t =
        static_cast<float>((weight_a * a.z + weight_b * b.z + weight_c * c.z) * per_weight);
    if (!(t >= t_min_ && t <= t_max)) return std::nullopt;
    return Hit{t, static_cast<float>(weight_b * per_weight),
               static_cast<float>(weight_c * per_weight), 0, normal_of(triangle)};
}

std::optional<Hit> intersect_triangle(const Ray& ray, const Triangle& triangle) noexcept {
    if (!is_traceable(ray)) return std::nullopt;
    return TriangleTest(ray)(triangle, ray.t_max);
}

}  // namespace coppice
