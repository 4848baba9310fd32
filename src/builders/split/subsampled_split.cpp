// Subsampled binning. In large nodes, a part of the PrimRefs, evenly spaced in the node's order,
// suffices to find a plane near the best. They are counted in bins, and the cheapest bin boundary
// is chosen. Its cost is then computed with all PrimRefs. Small nodes are searched exactly. Cost:
// O(1024) a node for the search, O(n) for the final count.
// Source: [Shevtsov2007] sec. 3.3 (min-max bins, sub-sampled geometry).

#include "builders/split/subsampled_split.h"

#include "builders/split/evaluate_plane.h"
#include "builders/split/exact_split.h"
#include "builders/split/node_bins.h"
#include "builders/split/small_node.h"

#include <algorithm>
#include <vector>

namespace coppice::inline v0 {
namespace {

constexpr std::size_t subsample_size = 1024;

std::vector<PrimRef> subsample(std::span<const PrimRef> prim_refs) {
    const std::size_t count = std::min(subsample_size, prim_refs.size());
    std::vector<PrimRef> part;
    part.reserve(count);
    for (std::size_t i = 0; i < count; ++i) {
        part.push_back(prim_refs[i * prim_refs.size() / count]);
    }
    return part;
}

}  // namespace

std::optional<SplitCandidate> SubsampledSplit::find(const SplitQuery& query) const {
    if (query.prim_refs.size() <= small_node_size) return find_in_small_node(query);
    const auto grid = bin_grid(query.box);
    if (!grid) return ExactSplit().find(query);
    const std::vector<PrimRef> part = subsample(query.prim_refs);
    const SplitQuery part_query{part, query.box, query.cost, query.acceptable_cost, query.isa};
    const NodeBins bins = bin_node(part, *grid, query.isa);
    const double weight = weight_of(part);
    std::optional<BinBoundary> best;
    for (const Axis axis : all_axes) {
        const auto boundary =
            best_boundary(part_query, axis, bins[static_cast<std::size_t>(axis)], weight);
        if (boundary && (!best || boundary->cost < best->cost)) best = boundary;
    }
    if (!best) return std::nullopt;
    return evaluate_plane(query, best->plane);
}

}  // namespace coppice::inline v0
