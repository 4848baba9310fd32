#pragma once

#include <array>
#include <cstdint>

namespace coppice::inline v0::bvh8 {

/// A triangle's box as the builder moves it about: the lower bound negated, so that one maximum of
/// eight lanes unites two boxes. Lane 3 is the id, lane 7 what the PrimRef counts in costs.
struct alignas(32) PrimRef {
    std::array<float, 3> negated_lower;
    std::uint32_t id;
    std::array<float, 3> upper;
    float weight;
};

static_assert(sizeof(PrimRef) == 32);

/// Eight lanes laid out as in PrimRef, lanes 3 and 7 without meaning: a box, or a range of
/// centroids (their sums lower + upper, negated and not). Not aligned: g++ 12 does not align every
/// temporary of a type that asks for more than 16 bytes.
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
