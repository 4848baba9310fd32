#pragma once

#include "coppice/builders/split_finder.h"

#include "builders/kernels/bin_ends.h"
#include "builders/split/evaluate_plane.h"

#include <cstddef>
#include <limits>
#include <optional>

namespace coppice::inline v0 {

/// A grid over a node's box; nothing if it is too small or too large for float arithmetic.
[[nodiscard]] std::optional<BinGrid> bin_grid(const Aabb& box) noexcept;

/// The bins of a node, counted in parallel where there are many PrimRefs.
[[nodiscard]] NodeBins bin_node(std::span<const PrimRef> prim_refs, const BinGrid& grid,
                                Isa isa = Isa::scalar);

/// The boundary before a bin of an axis.
struct BinBoundary {
    SplitPlane plane;
    std::size_t bin;  ///< in [1, bin_count)
    double cost;      ///< of a split at the plane
};

/// The boundary on an axis where a split costs least; nothing if the grid has none inside the node.
/// `weight`: of all PrimRefs.
[[nodiscard]] std::optional<BinBoundary> best_boundary(const SplitQuery& query, Axis axis,
                                                       const AxisBins& bins, double weight);

/// The weight of all PrimRefs in the bins of an axis.
[[nodiscard]] double weight_in(const AxisBins& bins) noexcept;

/// A split at a PrimRef end next to a boundary between bins.
struct BinnedPlane {
    SplitCandidate split{.plane = {}, .cost = std::numeric_limits<double>::infinity()};
    std::size_t bin = 0;  ///< the boundary is before this bin; in [0, bin_count]
};

/// Of the last end before and the first start after each boundary the one where a split costs
/// least, PrimRefs between the boundary and there counted on both sides; the cost is infinite if
/// none is inside the node. `before`: what reaches below the first bin, and above the last.
[[nodiscard]] BinnedPlane best_end(const AxisBins& bins, SplitCounts before,
                                   const PlaneEvaluator& evaluator);

}  // namespace coppice::inline v0
