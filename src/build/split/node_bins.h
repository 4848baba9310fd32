#pragma once

#include "coppice/build/split_finder.h"

#include "build/kernels/bin_ends.h"

#include <cstddef>
#include <optional>

namespace coppice {

/// The boundary before a bin of an axis.
struct BinBoundary {
    Axis axis;
    std::size_t bin;  ///< in [1, bin_count)
};

/// A grid over a node's box; nothing if it is too small or too large for float arithmetic.
[[nodiscard]] std::optional<BinGrid> bin_grid(const Aabb& box) noexcept;

/// The bins of a node, counted in parallel where there are many fragments.
[[nodiscard]] NodeBins bin_node(std::span<const Fragment> fragments, const BinGrid& grid);

/// The boundary where a plane would cost least, if fragments ended at bin boundaries; nothing if
/// there is no boundary between any two ends. `weight`: of all fragments.
[[nodiscard]] std::optional<BinBoundary> best_boundary(const SplitQuery& query,
                                                       const NodeBins& bins, double weight);

}  // namespace coppice
