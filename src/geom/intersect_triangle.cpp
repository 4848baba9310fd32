// The watertight ray-triangle test: the triangle is sheared into a space where the ray is the z
// axis, and three edge functions decide. Two triangles evaluate a shared edge from the same
// numbers with opposite sign, so that a ray between them cannot miss both. The original falls back
// to double where float gives zero; here all is double, which float input makes nearly exact.
// Source: [Woop2013] sec. 3.

#include "coppice/geom/triangle.h"

#include <cmath>

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

}  // namespace

TriangleTest::TriangleTest(const Ray& ray) noexcept
    : origin_(to_double(ray.origin)), t_min_(ray.t_min) {
    const Vec3d direction = to_double(ray.direction);
    for (const Axis axis : {Axis::y, Axis::z}) {
        if (std::abs(direction[axis]) > std::abs(direction[z_])) z_ = axis;
    }
    x_ = next_axis(z_);
    y_ = next_axis(x_);
    if (direction[z_] < 0.0) std::swap(x_, y_);
    scale_z_ = 1.0 / direction[z_];
    shear_x_ = direction[x_] * scale_z_;
    shear_y_ = direction[y_] * scale_z_;
}

Vec3d TriangleTest::to_frame(Vec3f corner) const noexcept {
    const Vec3d p = to_double(corner) - origin_;
    const double z = p[z_];
    return {p[x_] - shear_x_ * z, p[y_] - shear_y_ * z, scale_z_ * z};
}

std::optional<Hit> TriangleTest::operator()(const Triangle& triangle, float t_max) const noexcept {
    const Vec3d a = to_frame(triangle[0]);
    const Vec3d b = to_frame(triangle[1]);
    const Vec3d c = to_frame(triangle[2]);
    const double weight_a = edge_function(c, b);
    const double weight_b = edge_function(a, c);
    const double weight_c = edge_function(b, a);
    const bool any_negative = weight_a < 0.0 || weight_b < 0.0 || weight_c < 0.0;
    const bool any_positive = weight_a > 0.0 || weight_b > 0.0 || weight_c > 0.0;
    if (any_negative == any_positive) return std::nullopt;  // outside, or edge-on

    const double sum = weight_a + weight_b + weight_c;
    const auto t = static_cast<float>((weight_a * a.z + weight_b * b.z + weight_c * c.z) / sum);
    if (!(t >= t_min_ && t <= t_max)) return std::nullopt;
    return Hit{t, static_cast<float>(weight_b / sum), static_cast<float>(weight_c / sum), 0};
}

std::optional<Hit> intersect_triangle(const Ray& ray, const Triangle& triangle) noexcept {
    if (!is_traceable(ray)) return std::nullopt;
    return TriangleTest(ray)(triangle, ray.t_max);
}

}  // namespace coppice
