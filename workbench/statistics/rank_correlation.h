#pragma once

#include <optional>
#include <span>

namespace coppice::lab {

/// Spearman's rank correlation of two measures of the same things, in [-1, 1]: 1 if one always
/// grows with the other, however. `x` and `y` have one number for each thing. Equal numbers share
/// the mean of their ranks; pairs with a number that is not finite are passed over. Nothing for
/// fewer than three pairs, and where one measure is the same for all.
/// Source: [Spearman1904].
[[nodiscard]] std::optional<double> rank_correlation(std::span<const double> x,
                                                     std::span<const double> y);

}  // namespace coppice::lab
