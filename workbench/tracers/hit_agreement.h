#pragma once

#include "coppice/geom/ray.h"

#include <cstdint>
#include <span>

namespace coppice::lab {

/// The one tolerance of the workbench for hits of two tracers: distances that differ by at most
/// this share of the larger one are the same.
inline constexpr double same_distance_share = 1e-5;

/// True if two hits, or misses, are at the same distance by same_distance_share.
[[nodiscard]] bool is_same_distance(double a, double b) noexcept;

/// How many hits are at another distance than those of the reference for the same rays.
[[nodiscard]] std::uint64_t count_mismatches(std::span<const Hit> hits,
                                             std::span<const Hit> reference) noexcept;

}  // namespace coppice::lab
