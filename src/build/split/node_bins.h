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

/// The bin of an axis before which a plane would cost least; nothing if the grid has no boundary
/// inside the node. `weight`: of all fragments.
[[nodiscard]] std::optional<std::size_t> best_boundary(const SplitQuery& query, Axis axis,
                                                       const AxisBins& bins, double weight);

}  // namespace coppice
