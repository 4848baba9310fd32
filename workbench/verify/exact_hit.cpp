// The judge's test of one triangle. It has nothing in common with that of the library: the equation
// origin + t direction = a + u (b - a) + v (c - a) is solved by Cramer's rule, in rational numbers,
// which floats are.
// Source: [MollerTrumbore1997] (the equation).

#include "verify/exact_hit.h"

#include <gmpxx.h>

#include <algorithm>
#include <cmath>

namespace coppice::lab {

namespace {

using Rational = Vec3<mpq_class>;

Rational exact(Vec3f v) {
    return {mpq_class(v.x), mpq_class(v.y), mpq_class(v.z)};
}

double sum_of_abs(Vec3d v) {
    return std::abs(v.x) + std::abs(v.y) + std::abs(v.z);
}

}  // namespace

std::optional<double> exact_distance(const Ray& ray, const Triangle& triangle) {
    const Rational a = exact(triangle[0]);
    const Rational direction = exact(ray.direction);
    const Rational to_b = exact(triangle[1]) - a;
    const Rational to_c = exact(triangle[2]) - a;
    const Rational across = cross(direction, to_c);
    mpq_class determinant = dot(to_b, across);
    if (determinant == 0) return std::nullopt;
    const Rational from_a = exact(ray.origin) - a;
    const mpq_class u = dot(from_a, across) / determinant;
    if (u < 0 || u > 1) return std::nullopt;
    const Rational other = cross(from_a, to_b);
    const mpq_class v = dot(direction, other) / determinant;
    if (v < 0 || u + v > 1) return std::nullopt;
    return mpq_class(dot(to_c, other) / determinant).get_d();
}

bool may_meet(const Ray& ray, const Triangle& triangle) noexcept {
    const Vec3d origin = to_double(ray.origin);
    const Vec3d direction = to_double(ray.direction);
    const Vec3d a = to_double(triangle[0]) - origin;
    const Vec3d b = to_double(triangle[1]) - origin;
    const Vec3d c = to_double(triangle[2]) - origin;
    // Volumes between the ray and the edges. Each is a sum of six products of three numbers, which
    // no more than 10 roundings of 2^-53 go into.
    const double size_a = sum_of_abs(a);
    const double size_b = sum_of_abs(b);
    const double size_c = sum_of_abs(c);
    const double most_size = std::max({size_a, size_b, size_c});
    const double error = 0x1.0p-48 * sum_of_abs(direction) * most_size * most_size;
    const double ab = dot(direction, cross(a, b));
    const double bc = dot(direction, cross(b, c));
    const double ca = dot(direction, cross(c, a));
    const bool is_outside = std::min({ab, bc, ca}) < -error && std::max({ab, bc, ca}) > error;
    return !is_outside;
}

}  // namespace coppice::lab
