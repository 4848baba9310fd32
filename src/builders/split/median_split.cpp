// Median cut, the classic k-d tree: as many PrimRefs below the plane as above it. Cost: O(n) a
// node.
// Source: [Tsiompikas2022] sec. 2.2, [Bentley1975].

#include "builders/split/median_split.h"

#include "builders/split/evaluate_plane.h"

#include <algorithm>
#include <vector>

namespace coppice::inline v0 {
namespace {

float median_center(std::span<const PrimRef> prim_refs, Axis axis) {
    std::vector<float> centers;
    centers.reserve(prim_refs.size());
    for (const PrimRef& prim_ref : prim_refs) {
        centers.push_back(0.5F * prim_ref.box.lower[axis] + 0.5F * prim_ref.box.upper[axis]);
    }
    const auto middle = centers.begin() + static_cast<std::ptrdiff_t>(centers.size() / 2);
    std::nth_element(centers.begin(), middle, centers.end());
    return *middle;
}

}  // namespace

std::optional<SplitCandidate> MedianSplit::find(const SplitQuery& query) const {
    Axis axis = query.box.longest_axis();
    for (std::size_t tried = 0; tried < all_axes.size(); ++tried, axis = next_axis(axis)) {
        const float position = median_center(query.prim_refs, axis);
        if (PlaneEvaluator(query.box, axis, query.cost).is_inside(position)) {
            return evaluate_plane(query, {axis, position});
        }
    }
    return std::nullopt;
}

}  // namespace coppice::inline v0
