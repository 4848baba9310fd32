#include "tracers/hit_agreement.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace coppice::lab {

bool is_same_distance(double a, double b) noexcept {
    if (!std::isfinite(a) || !std::isfinite(b)) return a == b;
    return std::abs(a - b) <= same_distance_share * std::max(std::abs(a), std::abs(b));
}

std::uint64_t count_mismatches(std::span<const Hit> hits, std::span<const Hit> reference) noexcept {
    std::uint64_t count = 0;
    for (std::size_t i = 0; i < reference.size(); ++i) {
        count += is_same_distance(hits[i].t, reference[i].t) ? 0 : 1;
    }
    return count;
}

}  // namespace coppice::lab
