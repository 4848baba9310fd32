#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

namespace coppice::lab {

/// The median of at least one number: the one in the middle, or the mean of the two in the middle.
[[nodiscard]] inline double median_of(std::vector<double> values) {
    std::sort(values.begin(), values.end());
    const std::size_t half = values.size() / 2;
    return values.size() % 2 == 1 ? values[half] : 0.5 * (values[half - 1] + values[half]);
}

}  // namespace coppice::lab
