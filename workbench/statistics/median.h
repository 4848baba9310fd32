#pragma once

#include <algorithm>
#include <vector>

namespace coppice::lab {

/// The median of at least one number; of an even count the lower of the two in the middle.
[[nodiscard]] inline double median_of(std::vector<double> values) {
    std::sort(values.begin(), values.end());
    return values[(values.size() - 1) / 2];
}

}  // namespace coppice::lab
