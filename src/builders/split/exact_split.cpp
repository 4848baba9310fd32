// The surface area heuristic evaluated at every PrimRef end on every axis. Cost: O(n log n) a node;
// for whole trees, src/builders/kd/exact/ finds the same planes in O(n) a node.
// Source: [WaldHavran2006] sec. 4.2.

#include "builders/split/exact_split.h"

#include "builders/split/axis_sweep.h"
#include "builders/split/small_node.h"

namespace coppice::inline v0 {

std::optional<SplitCandidate> ExactSplit::find(const SplitQuery& query) const {
    if (query.prim_refs.size() <= small_node_size) return find_in_small_node(query);
    return sweep_all_axes(query);
}

}  // namespace coppice::inline v0
