#pragma once

#include <numeric>

namespace coppice::lab {

/// The mean of at least one number.
template <typename Values>
[[nodiscard]] double mean_of(const Values& values) {
    return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

}  // namespace coppice::lab
