// Spatial midpoint: halves the node on its longest axis. Cost: O(n) a node, for the counts.
// Source: [Tsiompikas2022] sec. 2.2.

#include "builders/split/midpoint_split.h"

#include "builders/split/evaluate_plane.h"

namespace coppice::inline v0 {

std::optional<SplitCandidate> MidpointSplit::find(const SplitQuery& query) const {
    const Axis axis = query.box.longest_axis();
    const float position = 0.5F * query.box.lower[axis] + 0.5F * query.box.upper[axis];
    if (!PlaneEvaluator(query.box, axis, query.cost).is_inside(position)) return std::nullopt;
    return evaluate_plane(query, {axis, position});
}

}  // namespace coppice::inline v0
