#pragma once

#include <array>
#include <cstdint>

namespace coppice::inline v0::bvh8 {

/// A triangle's box in the layout of the 8-wide builder. The lower bound is negated, so that one
/// maximum over eight lanes unites two boxes. Lane 3 is the id, lane 7 the weight in costs.
struct alignas(32) PrimRef {
    std::array<float, 3> negated_lower;
    std::uint32_t id;
    std::array<float, 3> upper;
    float weight;
};

static_assert(sizeof(PrimRef) == 32);

/// Eight lanes in the layout of PrimRef, with lanes 3 and 7 unused: a box, or bounds of centroids
/// (of the sums lower + upper). Not aligned, because g++ 12 does not align every temporary of a
/// type with an alignment above 16 bytes.
struct Box8 {
    std::array<float, 8> lane;

    /// The empty box.
    [[nodiscard]] static constexpr Box8 make_empty() noexcept {
        constexpr float lowest = -__builtin_inff();
        return {{lowest, lowest, lowest, lowest, lowest, lowest, lowest, lowest}};
    }

    [[nodiscard]] constexpr float lower(std::size_t axis) const noexcept { return -lane[axis]; }

    [[nodiscard]] constexpr float upper(std::size_t axis) const noexcept { return lane[4 + axis]; }

    constexpr void grow(const Box8& other) noexcept {
        for (std::size_t i = 0; i < lane.size(); ++i) {
            lane[i] = lane[i] < other.lane[i] ? other.lane[i] : lane[i];
        }
    }
};

}  // namespace coppice::inline v0::bvh8
