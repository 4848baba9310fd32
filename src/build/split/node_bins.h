#pragma once

#include "coppice/build/split_finder.h"

#include "build/kernels/bin_ends.h"
#include "build/split/evaluate_plane.h"

#include <cstddef>
#include <limits>
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

/// The weight of all fragments in the bins of an axis.
[[nodiscard]] double weight_in(const AxisBins& bins) noexcept;

/// A split at a fragment end next to a boundary between bins.
struct BinnedPlane {
    Split split{.plane = {}, .cost = std::numeric_limits<double>::infinity()};
    std::size_t bin = 0;  ///< the boundary is before this bin; in [0, bin_count]
};

/// Of the last end before and the first start after each boundary the one where a split costs
/// least, fragments between the boundary and there counted on both sides; the cost is infinite if
/// none is inside the node. `before`: what reaches below the first bin, and above the last.
[[nodiscard]] BinnedPlane best_end(const AxisBins& bins, SplitCounts before,
                                   const PlaneEvaluator& evaluator);

}  // namespace coppice
