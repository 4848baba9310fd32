// The correlation coefficient of the ranks, which also holds with ties; O(n log n).
// Source: [Spearman1904].

#include "statistics/rank_correlation.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <vector>

namespace coppice::lab {

namespace {

/// Ranks from 0 on, less their mean.
std::vector<double> centred_ranks(const std::vector<double>& values) {
    std::vector<std::size_t> order(values.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::sort(order.begin(), order.end(),
              [&](std::size_t a, std::size_t b) { return values[a] < values[b]; });
    const double mean = 0.5 * (static_cast<double>(values.size()) - 1.0);
    std::vector<double> ranks(values.size());
    for (std::size_t first = 0; first < order.size();) {
        std::size_t end = first;
        while (end < order.size() && values[order[end]] == values[order[first]]) {
            ++end;
        }
        for (std::size_t i = first; i < end; ++i) {
            ranks[order[i]] = 0.5 * static_cast<double>(first + end - 1) - mean;
        }
        first = end;
    }
    return ranks;
}

}  // namespace

std::optional<double> rank_correlation(std::span<const double> x, std::span<const double> y) {
    std::vector<double> finite_x;
    std::vector<double> finite_y;
    for (std::size_t i = 0; i < x.size(); ++i) {
        if (!std::isfinite(x[i]) || !std::isfinite(y[i])) continue;
        finite_x.push_back(x[i]);
        finite_y.push_back(y[i]);
    }
    if (finite_x.size() < 3) return std::nullopt;
    const std::vector<double> a = centred_ranks(finite_x);
    const std::vector<double> b = centred_ranks(finite_y);
    const double aa = std::inner_product(a.begin(), a.end(), a.begin(), 0.0);
    const double bb = std::inner_product(b.begin(), b.end(), b.begin(), 0.0);
    if (aa == 0.0 || bb == 0.0) return std::nullopt;
    return std::inner_product(a.begin(), a.end(), b.begin(), 0.0) / std::sqrt(aa * bb);
}

}  // namespace coppice::lab
