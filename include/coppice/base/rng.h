#pragma once

#include <cstdint>

namespace coppice::inline v0 {

/// A uniformly distributed 64-bit word that depends on (seed, counter) alone. This counter-based
/// generator is behind every random choice of the library, so that results do not depend on threads
/// or on order. Two rounds of the SplitMix64 finalizer.
/// Source: [Steele2014] sec. 5, [Salmon2011].
[[nodiscard]] constexpr std::uint64_t random_bits(std::uint64_t seed,
                                                  std::uint64_t counter) noexcept {
    const auto mix = [](std::uint64_t z) {
        z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9ULL;
        z = (z ^ (z >> 27)) * 0x94d049bb133111ebULL;
        return z ^ (z >> 31);
    };
    constexpr std::uint64_t golden_gamma = 0x9e3779b97f4a7c15ULL;
    return mix(mix(seed + golden_gamma) + (counter + 1) * golden_gamma);
}

/// A double in [0, 1) that depends on (seed, counter) alone.
[[nodiscard]] constexpr double random_unit(std::uint64_t seed, std::uint64_t counter) noexcept {
    return static_cast<double>(random_bits(seed, counter) >> 11) * 0x1.0p-53;
}

}  // namespace coppice::inline v0
