#pragma once

#include "coppice/geom/ray.h"
#include "coppice/geom/triangle_mesh.h"

#include <fuzzer/FuzzedDataProvider.h>

#include <array>
#include <bit>
#include <cstdint>
#include <limits>

namespace coppice::fuzz {

/// Any float: on a coarse grid, where things coincide, of those that break arithmetic, or any bits.
[[nodiscard]] inline float take_float(FuzzedDataProvider& data) {
    using Limits = std::numeric_limits<float>;
    constexpr std::array special{0.0F,
                                 -0.0F,
                                 1e38F,
                                 -1e38F,
                                 1e-38F,
                                 -1e-38F,
                                 Limits::max(),
                                 Limits::lowest(),
                                 Limits::min(),
                                 Limits::denorm_min(),
                                 -Limits::denorm_min(),
                                 Limits::epsilon(),
                                 1.0F + Limits::epsilon(),
                                 148376.0F,
                                 -223423.0F,
                                 1e19F,
                                 1e-22F,
                                 Limits::infinity(),
                                 -Limits::infinity(),
                                 Limits::quiet_NaN()};
    const auto choice = data.ConsumeIntegral<std::uint8_t>();
    if (choice < 160) return 0.125F * static_cast<float>(choice - 80);
    if (choice < 200) return special[choice % special.size()];
    return std::bit_cast<float>(data.ConsumeIntegral<std::uint32_t>());
}

[[nodiscard]] inline Vec3f take_point(FuzzedDataProvider& data) {
    const float x = take_float(data);
    const float y = take_float(data);
    return {x, y, take_float(data)};
}

/// A point that rays like to be aimed at: a vertex, the middle of an edge, or any.
[[nodiscard]] inline Vec3f take_target(FuzzedDataProvider& data, TriangleMeshView mesh) {
    const int choice = data.ConsumeIntegralInRange(0, 3);
    if (mesh.size() == 0 || choice == 0) return take_point(data);
    const Triangle triangle =
        mesh.triangle(data.ConsumeIntegralInRange<std::uint32_t>(0, mesh.size() - 1));
    if (choice == 1) return triangle[0];
    const Vec3f middle = 0.5F * (triangle[0] + triangle[1]);
    return choice == 2 ? middle : 0.5F * (middle + triangle[2]);
}

/// A ray of any kind: from or at such a point, along an axis, in a plane of the grid, with limits.
[[nodiscard]] inline Ray take_ray(FuzzedDataProvider& data, TriangleMeshView mesh) {
    Ray ray{.origin = take_target(data, mesh)};
    ray.direction = data.ConsumeBool() ? take_target(data, mesh) - ray.origin : take_point(data);
    const auto zeros = data.ConsumeIntegral<std::uint8_t>();
    for (const Axis axis : all_axes) {
        const int bit = 2 * static_cast<int>(axis);
        if ((zeros >> bit & 3) == 3) ray.direction[axis] = (zeros & 64) != 0 ? 0.0F : -0.0F;
    }
    if (data.ConsumeIntegralInRange(0, 3) == 0) {
        ray.t_min = take_float(data);
        ray.t_max = take_float(data);
    }
    return ray;
}

}  // namespace coppice::fuzz
