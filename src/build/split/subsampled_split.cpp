// In large nodes a part of the fragments, evenly spaced in the node's order, is enough to see where
// the best plane is about: they are counted in bins, and the cheapest bin boundary is taken. What
// it costs is then counted with all fragments. Small nodes are searched exactly.
// Cost: O(1024) a node for the search, O(n) for the count.
// Source: [Shevtsov2007] sec. 3.3 (min-max bins, sub-sampled geometry).

#include "build/split/subsampled_split.h"

#include "build/split/evaluate_plane.h"
#include "build/split/exact_split.h"
#include "build/split/node_bins.h"
#include "build/split/small_node.h"

#include <algorithm>
#include <vector>

namespace coppice {
namespace {

constexpr std::size_t subsample_size = 1024;

std::vector<Fragment> subsample(std::span<const Fragment> fragments) {
    const std::size_t count = std::min(subsample_size, fragments.size());
    std::vector<Fragment> part;
    part.reserve(count);
    for (std::size_t i = 0; i < count; ++i) {
        part.push_back(fragments[i * fragments.size() / count]);
    }
    return part;
}

}  // namespace

std::optional<Split> SubsampledSplit::find(const SplitQuery& query) const {
    if (query.fragments.size() <= small_node_size) return find_in_small_node(query);
    const auto grid = bin_grid(query.box);
    if (!grid) return ExactSplit().find(query);
    const std::vector<Fragment> part = subsample(query.fragments);
    const SplitQuery part_query{part, query.box, query.cost, query.acceptable_cost, query.isa};
    const NodeBins bins = bin_node(part, *grid);
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

}  // namespace coppice
