// One pass over the sorted events of an axis gives the counts on both sides of the plane at every
// event. Cost: O(n log n) for the sort.
// Source: [WaldHavran2006] sec. 4.2, [Pharr2016] sec. 4.4.2.

#include "builders/split/axis_events.h"

#include "coppice/base/parallel.h"

#include "base/cancellation_poll.h"
#include "builders/split/sort_key.h"

#include <algorithm>
#include <span>

namespace coppice::inline v0 {
namespace {

// Iterates over the events of one kind.
class EventCursor {
public:
    explicit EventCursor(std::span<const std::uint64_t> keys) noexcept : keys_(keys) {}

    [[nodiscard]] float next() const noexcept {
        return passed_ < keys_.size() ? position_of(keys_[passed_]) : Aabb::infinity;
    }

    // Passes all events at `position`, which must be the next position of all kinds. Returns their
    // weight.
    double pass(float position) noexcept {
        double weight = 0.0;
        while (passed_ < keys_.size() && position_of(keys_[passed_]) == position) {
            weight += weight_of(keys_[passed_++]);
        }
        return weight;
    }

private:
    std::span<const std::uint64_t> keys_;
    std::size_t passed_ = 0;
};

}  // namespace

void AxisEvents::add(const PrimRef& prim_ref, Axis axis) {
    add(prim_ref, axis, true, true);
}

void AxisEvents::add(const PrimRef& prim_ref, Axis axis, bool with_start, bool with_end) {
    const float lower = prim_ref.box.lower[axis];
    const float upper = prim_ref.box.upper[axis];
    if (lower == upper) {
        planars.push_back(sort_key(lower, prim_ref.weight));
        return;
    }
    if (with_start) starts.push_back(sort_key(lower, prim_ref.weight));
    if (with_end) ends.push_back(sort_key(upper, prim_ref.weight));
}

void sweep_events(AxisEvents& events, const PlaneEvaluator& evaluator, SplitCounts counts,
                  BestSplit& best) {
    parallel_sort(events.starts);
    parallel_sort(events.ends);
    parallel_sort(events.planars);
    EventCursor starts(events.starts);
    EventCursor ends(events.ends);
    EventCursor planars(events.planars);
    CancellationPoll look;
    for (std::size_t step = 0;; ++step) {
        look.at(step);
        const float position = std::min({starts.next(), ends.next(), planars.next()});
        if (position == Aabb::infinity) return;
        // PrimRefs that end at the plane are below it, those that start there above it.
        counts.above -= ends.pass(position);
        counts.in_plane = planars.pass(position);
        counts.above -= counts.in_plane;
        if (evaluator.is_inside(position)) best.offer(evaluator.evaluate(position, counts));
        counts.below += starts.pass(position) + counts.in_plane;
    }
}

}  // namespace coppice::inline v0
