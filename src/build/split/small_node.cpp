// Small nodes are searched exactly without sorting: all ends strictly inside the node are candidate
// planes, and a vector kernel counts what lies on either side of each.
// Cost: O(n^2 / 8) for n fragments, on each axis.

#include "build/split/small_node.h"

#include "build/kernels/plane_costs.h"
#include "build/split/best_split.h"
#include "build/split/evaluate_plane.h"

#include <array>

namespace coppice {
namespace {

void gather(std::span<const Fragment> fragments, std::array<AxisEnds, 3>& ends) noexcept {
    for (std::size_t i = 0; i < fragments.size(); ++i) {
        const Fragment& fragment = fragments[i];
        for (const Axis axis : all_axes) {
            AxisEnds& on_axis = ends[static_cast<std::size_t>(axis)];
            const float lower = fragment.box.lower[axis];
            const float upper = fragment.box.upper[axis];
            on_axis.lower[i] = lower;
            on_axis.upper[i] = upper;
            on_axis.weight[i] = fragment.weight;
            on_axis.has_planar |= lower == upper;
        }
    }
    for (AxisEnds& on_axis : ends)
        on_axis.count = fragments.size();
}

void list_planes(const AxisEnds& ends, const PlaneEvaluator& evaluator,
                 AxisPlanes& planes) noexcept {
    std::size_t count = 0;
    const auto list = [&](float position) {
        planes.position[count] = position + 0.0F;  // never -0: of equal planes either may be chosen
        count += evaluator.is_inside(position) ? 1U : 0U;
    };
    for (std::size_t i = 0; i < ends.count; ++i)
        list(ends.lower[i]);
    for (std::size_t i = 0; i < ends.count; ++i)
        list(ends.upper[i]);
    planes.count = count;
}

void search_axis(const AxisEnds& ends, const PlaneEvaluator& evaluator, BestSplit& best) noexcept {
    AxisPlanes planes;
    list_planes(ends, evaluator, planes);
    if (planes.count == 0) return;
    const double least = find_plane_costs(ends, evaluator.terms(), planes);
    if (least > best.cost()) return;
    for (std::size_t i = 0; i < planes.count; ++i) {
        if (planes.cost[i] != least) continue;
        best.offer(evaluator.evaluate(planes.position[i],
                                      {planes.below[i], planes.above[i], planes.in_plane[i]}));
    }
}

}  // namespace

std::optional<Split> find_in_small_node(const SplitQuery& query) noexcept {
    std::array<AxisEnds, 3> ends;
    gather(query.fragments, ends);
    BestSplit best;
    for (const Axis axis : all_axes) {
        search_axis(ends[static_cast<std::size_t>(axis)],
                    PlaneEvaluator(query.box, axis, query.cost), best);
    }
    return best.get();
}

}  // namespace coppice
