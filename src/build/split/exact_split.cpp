// The surface area heuristic without a compromise: every fragment end on every axis is considered.
// Cost: O(n log n) a node. src/build/exact/ finds the same planes in O(n) a node, for whole trees.
// Source: [WaldHavran2006] sec. 4.2.

#include "build/split/exact_split.h"

#include "build/split/axis_sweep.h"
#include "build/split/best_split.h"
#include "build/split/small_node.h"

namespace coppice {

std::optional<Split> ExactSplit::find(const SplitQuery& query) const {
    if (query.fragments.size() <= small_node_size) return find_in_small_node(query);
    BestSplit best;
    for (const Axis axis : all_axes) {
        if (const auto split = sweep_axis(query, axis)) best.offer(*split);
    }
    return best.get();
}

}  // namespace coppice
