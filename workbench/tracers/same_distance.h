#pragma once

#include <algorithm>
#include <cmath>

namespace coppice::lab {

/// True if two hits, or misses, are at the same distance by 1e-5 of it.
[[nodiscard]] inline bool is_same_distance(double a, double b) noexcept {
    if (!std::isfinite(a) || !std::isfinite(b)) return a == b;
    return std::abs(a - b) <= 1e-5 * std::max(std::abs(a), std::abs(b));
}

}  // namespace coppice::lab
