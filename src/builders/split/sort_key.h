#pragma once

#include <bit>
#include <cstdint>

namespace coppice::inline v0 {

/// Packs a position and a weight into one integer that sorts by position, then by weight. So a sort
/// has one result whatever the order of its input. -0 becomes +0. Position and weight must be
/// finite.
[[nodiscard]] inline std::uint64_t sort_key(float position, float weight) noexcept {
    const auto bits = std::bit_cast<std::uint32_t>(position + 0.0F);
    const std::uint32_t ordered = bits ^ ((bits >> 31) != 0 ? 0xffffffffU : 0x80000000U);
    return static_cast<std::uint64_t>(ordered) << 32 | std::bit_cast<std::uint32_t>(weight);
}

/// Unpacks the position of a sort_key().
[[nodiscard]] inline float position_of(std::uint64_t key) noexcept {
    const auto ordered = static_cast<std::uint32_t>(key >> 32);
    const std::uint32_t bits = ordered ^ ((ordered >> 31) != 0 ? 0x80000000U : 0xffffffffU);
    return std::bit_cast<float>(bits);
}

/// Unpacks the weight of a sort_key().
[[nodiscard]] inline float weight_of(std::uint64_t key) noexcept {
    return std::bit_cast<float>(static_cast<std::uint32_t>(key));
}

}  // namespace coppice::inline v0
