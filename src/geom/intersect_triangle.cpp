// The watertight ray-triangle test: the triangle is sheared into a space where the ray is the z
// axis, and three edge functions decide. Two triangles evaluate a shared edge from the same
// numbers with opposite sign, so that a ray between them cannot miss both. The original falls back
// to double where float gives zero; here all is double, which float input makes nearly exact.
// Source: [Woop2013] sec. 3.

#include "coppice/geom/triangle.h"

#include <cmath>

namespace coppice {
namespace {

// The ray's axes, longest component last, wound so that the triangle's orientation is kept.
struct RayFrame {
    Axis x;
    Axis y;
    Axis z;
    double shear_x;
    double shear_y;
    double scale_z;
};

RayFrame make_frame(Vec3d direction) noexcept {
    Axis z = Axis::x;
    for (const Axis axis : {Axis::y, Axis::z}) {
        if (std::abs(direction[axis]) > std::abs(direction[z])) z = axis;
    }
    Axis x = next_axis(z);
    Axis y = next_axis(x);
    if (direction[z] < 0.0) std::swap(x, y);
    return {x, y, z, direction[x] / direction[z], direction[y] / direction[z], 1.0 / direction[z]};
}

Vec3d to_frame(const RayFrame& frame, Vec3d p) noexcept {
    const double z = p[frame.z];
    return {p[frame.x] - frame.shear_x * z, p[frame.y] - frame.shear_y * z, frame.scale_z * z};
}

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

std::optional<Hit> intersect_triangle(const Ray& ray, const Triangle& triangle) noexcept {
    if (!is_traceable(ray)) return std::nullopt;
    const RayFrame frame = make_frame(to_double(ray.direction));
    const Vec3d origin = to_double(ray.origin);
    const Vec3d a = to_frame(frame, to_double(triangle[0]) - origin);
    const Vec3d b = to_frame(frame, to_double(triangle[1]) - origin);
    const Vec3d c = to_frame(frame, to_double(triangle[2]) - origin);

    const double weight_a = edge_function(c, b);
    const double weight_b = edge_function(a, c);
    const double weight_c = edge_function(b, a);
    const bool any_negative = weight_a < 0.0 || weight_b < 0.0 || weight_c < 0.0;
    const bool any_positive = weight_a > 0.0 || weight_b > 0.0 || weight_c > 0.0;
    if (any_negative == any_positive) return std::nullopt;  // outside, or edge-on

    const double sum = weight_a + weight_b + weight_c;
    const auto t = static_cast<float>((weight_a * a.z + weight_b * b.z + weight_c * c.z) / sum);
    if (!(t >= ray.t_min && t <= ray.t_max)) return std::nullopt;
    return Hit{t, static_cast<float>(weight_b / sum), static_cast<float>(weight_c / sum), 0};
}

}  // namespace coppice
