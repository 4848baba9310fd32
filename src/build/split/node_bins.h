#pragma once

#include "coppice/build/split_finder.h"

#include "build/kernels/bin_ends.h"

#include <cstddef>
#include <optional>

namespace coppice {

/// A grid over a node's box; nothing if it is too small or too large for float arithmetic.
[[nodiscard]] std::optional<BinGrid> bin_grid(const Aabb& box) noexcept;

/// The bins of a node, counted in parallel where there are many fragments.
[[nodiscard]] NodeBins bin_node(std::span<const Fragment> fragments, const BinGrid& grid);

/// The boundary before a bin of an axis.
struct BinBoundary {
    Plane plane;
    std::size_t bin;  ///< in [1, bin_count)
    double cost;      ///< of a split at the plane
};

/// The boundary on an axis where a split costs least; nothing if the grid has none inside the node.
/// `weight`: of all fragments.
[[nodiscard]] std::optional<BinBoundary> best_boundary(const SplitQuery& query, Axis axis,
                                                       const AxisBins& bins, double weight);

}  // namespace coppice
