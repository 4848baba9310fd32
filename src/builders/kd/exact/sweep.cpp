// One pass over the sorted events of each axis gives the counts on both sides of the plane at every
// event. Cost: O(n) a node.
// Source: [WaldHavran2006] sec. 4.2.

#include "builders/kd/exact/sweep.h"

#include "base/cancellation_poll.h"
#include "builders/split/best_split.h"
#include "builders/split/evaluate_plane.h"

#include <array>

namespace coppice::inline v0 {
namespace {

template <typename WeightOf>
BestSplit sweep_axis_events(const EventList& events, const PlaneEvaluator& evaluator, double weight,
                            WeightOf&& weight_of) {
    BestSplit best;
    SplitCounts counts{0.0, weight, 0.0};
    CancellationPoll look;
    for (std::size_t i = 0; i < events.size();) {
        look.at(i);
        const float position = position_of(events[i]);
        std::array<double, 3> passed{};  // weights of events at this position, by kind
        for (; i < events.size() && position_of(events[i]) == position; ++i) {
            passed[static_cast<std::size_t>(kind_of(events[i]))] += weight_of(events[i]);
        }
        const auto [ends, planars, starts] = passed;
        // PrimRefs that end at the plane are below it, those that start there above it.
        counts.above -= ends + planars;
        counts.in_plane = planars;
        if (evaluator.is_inside(position)) best.offer(evaluator.evaluate(position, counts));
        counts.below += starts + planars;
    }
    return best;
}

}  // namespace

std::optional<SplitCandidate> sweep(const ExactNode& node, const Aabb& box, double weight,
                                    const SahCostModel& cost) {
    // Weights are at least 1. If their sum equals the number of PrimRefs, each is 1.
    const bool are_all_one = weight == static_cast<double>(node.prim_refs.size());
    std::array<BestSplit, 3> best_of_axis;
    for_each_axis(node.prim_refs.size(), [&](Axis axis) {
        const auto index = static_cast<std::size_t>(axis);
        const PlaneEvaluator evaluator(box, axis, cost);
        best_of_axis[index] =
            are_all_one
                ? sweep_axis_events(node.events[index], evaluator, weight,
                                    [](EventKey) { return 1.0; })
                : sweep_axis_events(node.events[index], evaluator, weight, [&](EventKey event) {
                      return static_cast<double>(node.prim_refs[slot_of(event)].weight);
                  });
    });
    BestSplit best;
    for (const BestSplit& on_axis : best_of_axis) {
        if (on_axis.get()) best.offer(*on_axis.get());
    }
    return best.get();
}

}  // namespace coppice::inline v0
