#pragma once

#include <algorithm>
#include <cstddef>

namespace coppice::lab {

/// A percentile by nearest rank: the smallest value that at least `percent` (in [0, 100]) of all
/// values do not exceed. There is at least one value, and they are in ascending order.
template <typename Values>
[[nodiscard]] auto percentile_of(const Values& sorted, std::size_t percent) {
    const std::size_t rank = (sorted.size() * percent + 99) / 100;
    return sorted[std::max<std::size_t>(rank, 1) - 1];
}

}  // namespace coppice::lab
