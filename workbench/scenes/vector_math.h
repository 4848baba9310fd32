#pragma once

#include "coppice/geom/vec3.h"

#include <algorithm>
#include <cmath>

namespace coppice::render {

[[nodiscard]] inline double length(Vec3d v) noexcept {
    return std::sqrt(dot(v, v));
}

/// The vector at length 1; 0 if it has no length.
[[nodiscard]] inline Vec3d normalized(Vec3d v) noexcept {
    // First to a size whose square neither overflows nor vanishes.
    const double size = std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)});
    if (!(size > 0.0)) return {};
    const Vec3d scaled = (1.0 / size) * v;
    return (1.0 / length(scaled)) * scaled;
}

/// Component by component: light of one colour on a surface of another.
[[nodiscard]] constexpr Vec3d product(Vec3d a, Vec3d b) noexcept {
    return {a.x * b.x, a.y * b.y, a.z * b.z};
}

[[nodiscard]] constexpr double largest(Vec3d v) noexcept {
    return std::max({v.x, v.y, v.z});
}

/// Unit vectors that are at right angles to a unit vector and to each other.
struct Tangents {
    Vec3d first;
    Vec3d second;
};

[[nodiscard]] inline Tangents tangents_of(Vec3d normal) noexcept {
    const Vec3d other = std::abs(normal.x) < 0.9 ? Vec3d{1.0, 0.0, 0.0} : Vec3d{0.0, 1.0, 0.0};
    const Vec3d first = normalized(cross(normal, other));
    return {first, cross(normal, first)};
}

}  // namespace coppice::render
