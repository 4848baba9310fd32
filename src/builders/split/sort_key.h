#pragma once

#include <bit>
#include <cstdint>

namespace coppice::inline v0 {

/// A position and a weight in one number that sorts by position, then by weight: so that sorting
/// has one result whatever the order before. -0 becomes +0. Position and weight are finite.
[[nodiscard]] inline std::uint64_t sort_key(float position, float weight) noexcept {
    const auto bits = std::bit_cast<std::uint32_t>(position + 0.0F);
    const std::uint32_t ordered = bits ^ ((bits >> 31) != 0 ? 0xffffffffU : 0x80000000U);
    return static_cast<std::uint64_t>(ordered) << 32 | std::bit_cast<std::uint32_t>(weight);
}

/// The position of a sort_key().
[[nodiscard]] inline float position_of(std::uint64_t key) noexcept {
    const auto ordered = static_cast<std::uint32_t>(key >> 32);
    const std::uint32_t bits = ordered ^ ((ordered >> 31) != 0 ? 0x80000000U : 0xffffffffU);
    return std::bit_cast<float>(bits);
}

/// The weight of a sort_key().
[[nodiscard]] inline float weight_of(std::uint64_t key) noexcept {
    return std::bit_cast<float>(static_cast<std::uint32_t>(key));
}

}  // namespace coppice::inline v0
