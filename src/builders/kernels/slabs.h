#pragma once

#include "builders/bvh8/prim_ref.h"

#include <array>
#include <cstddef>
#include <cstdint>

namespace coppice::inline v0::bvh8 {

inline constexpr std::size_t slab_count = 16;

/// A plane perpendicular to an axis, by the axis's index.
struct CutPlane {
    std::size_t axis;
    float position;
};

/// A division of a box into equal slabs on each axis.
struct Slabs {
    explicit Slabs(const Box8& box) noexcept {
        for (std::size_t axis = 0; axis < 3; ++axis) {
            lower[axis] = box.lower(axis);
            width[axis] = (box.upper(axis) - lower[axis]) / static_cast<float>(slab_count);
            const bool has_width = width[axis] >= 0x1.0p-100F;
            per_width[axis] = has_width ? 1.0F / width[axis] : 0.0F;
        }
    }

    /// The slab that contains a position.
    [[nodiscard]] std::size_t at(std::size_t axis, float place) const noexcept {
        constexpr auto last = static_cast<float>(slab_count - 1);
        const float slab = (place - lower[axis]) * per_width[axis];
        return static_cast<std::size_t>(slab < last ? slab : last);
    }

    /// The plane at the lower border of a slab.
    [[nodiscard]] CutPlane below(std::size_t axis, std::size_t slab) const noexcept {
        return {axis, lower[axis] + static_cast<float>(slab) * width[axis]};
    }

    std::array<float, 3> lower;
    std::array<float, 3> width;
    std::array<float, 3> per_width;
};

/// The contents of each slab of an axis: the box of all pieces of triangles, and the numbers of
/// triangles that begin and end there.
struct SlabContents {
    SlabContents() noexcept { box.fill(Box8::make_empty()); }

    /// Adds the contents counted by another task.
    void add(const SlabContents& other) noexcept {
        for (std::size_t slab = 0; slab < slab_count; ++slab) {
            box[slab].grow(other.box[slab]);
            begin[slab] += other.begin[slab];
            end[slab] += other.end[slab];
        }
    }

    std::array<Box8, slab_count> box;
    std::array<std::uint32_t, slab_count> begin{};
    std::array<std::uint32_t, slab_count> end{};
};

}  // namespace coppice::inline v0::bvh8
