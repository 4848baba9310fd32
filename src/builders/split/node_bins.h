#pragma once

#include "coppice/builders/split_finder.h"

#include "builders/kernels/bin_ends.h"
#include "builders/split/evaluate_plane.h"

#include <cstddef>
#include <limits>
#include <optional>

namespace coppice::inline v0 {

/// A grid of bins over a node's box; nothing if the box is too small or too large for float
/// arithmetic.
[[nodiscard]] std::optional<BinGrid> bin_grid(const Aabb& box) noexcept;

/// The bins of a node, filled in parallel if there are many PrimRefs.
[[nodiscard]] NodeBins bin_node(std::span<const PrimRef> prim_refs, const BinGrid& grid,
                                Isa isa = Isa::scalar);

/// The boundary between two bins of an axis, as a split.
struct BinBoundary {
    SplitPlane plane;
    std::size_t bin;  ///< the bin after the boundary; in [1, bin_count)
    double cost;      ///< cost of a split at the plane
};

/// The boundary on an axis with the cheapest split; nothing if no boundary is inside the node.
/// `weight` is the sum of all PrimRefs' weights.
[[nodiscard]] std::optional<BinBoundary> best_boundary(const SplitQuery& query, Axis axis,
                                                       const AxisBins& bins, double weight);

/// The weight of all PrimRefs that start in the bins of an axis.
[[nodiscard]] double weight_in(const AxisBins& bins) noexcept;

/// A split at a PrimRef end next to a boundary between bins.
struct BinnedPlane {
    SplitCandidate split{.plane = {}, .cost = std::numeric_limits<double>::infinity()};
    std::size_t bin = 0;  ///< the boundary is before this bin; in [0, bin_count]
};

/// The cheapest split at the last end before or the first start after a boundary between bins.
/// PrimRefs between the boundary and that end count on both sides. The cost is infinite if there is
/// no such plane inside the node. `before` holds the weights below the first bin and above the last
/// one.
[[nodiscard]] BinnedPlane best_end(const AxisBins& bins, SplitCounts before,
                                   const PlaneEvaluator& evaluator);

}  // namespace coppice::inline v0
