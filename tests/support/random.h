#pragma once

#include "coppice/base/rng.h"
#include "coppice/geom/aabb.h"
#include "coppice/geom/vec3.h"

#include <cmath>
#include <cstdint>
#include <numbers>

namespace coppice::test {

/// A stream of random numbers that depends on its seed alone.
class Random {
public:
    explicit Random(std::uint64_t seed) noexcept : seed_(seed) {}

    [[nodiscard]] std::uint64_t bits() noexcept { return random_bits(seed_, counter_++); }

    /// In [0, 1).
    [[nodiscard]] double unit() noexcept { return random_unit(seed_, counter_++); }

    /// In [least, most].
    [[nodiscard]] float uniform(float least, float most) noexcept {
        return static_cast<float>(least + (static_cast<double>(most) - least) * unit());
    }

    /// In [0, count), for count > 0.
    [[nodiscard]] std::uint32_t below(std::uint32_t count) noexcept {
        return static_cast<std::uint32_t>(unit() * count);
    }

    [[nodiscard]] Vec3f in_box(const Aabb& box) noexcept {
        Vec3f point;
        for (const Axis axis : all_axes) {
            point[axis] = uniform(box.lower[axis], box.upper[axis]);
        }
        return point;
    }

    /// Uniform on the unit sphere, in double.
    [[nodiscard]] Vec3d direction() noexcept {
        const double z = 2.0 * unit() - 1.0;
        const double angle = 2.0 * std::numbers::pi * unit();
        const double radius = std::sqrt(1.0 - z * z);
        return {radius * std::cos(angle), radius * std::sin(angle), z};
    }

private:
    std::uint64_t seed_;
    std::uint64_t counter_ = 0;
};

}  // namespace coppice::test
