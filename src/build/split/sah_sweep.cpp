// The full sweep of the surface area heuristic: every fragment end inside the node is a candidate
// plane; sorted starts, ends and planar positions give the counts on both sides in one pass.
// The longest axis is tried first and the others only where it has no acceptable split: the
// scheme of pbrt that the thesis uses, not the minimum over all three axes.
// Cost: O(n log n) a node and axis.
// Source: [Tsiompikas2022] sec. 4.3.1, [Pharr2016] sec. 4.4.2; planar events [WaldHavran2006]
// sec. 4.2.

#include "build/split/sah_sweep.h"

#include "coppice/base/parallel.h"

#include "build/split/evaluate_plane.h"

#include <algorithm>
#include <limits>
#include <vector>

namespace coppice {
namespace {

// The positions of a node's events on one axis, each kind sorted.
struct Events {
    std::vector<float> starts;
    std::vector<float> ends;
    std::vector<float> planars;
};

Events sorted_events(std::span<const Fragment> fragments, Axis axis) {
    Events events;
    events.starts.reserve(fragments.size());
    events.ends.reserve(fragments.size());
    for (const Fragment& fragment : fragments) {
        const float lower = fragment.box.lower[axis];
        const float upper = fragment.box.upper[axis];
        if (lower == upper) {
            events.planars.push_back(lower);
        } else {
            events.starts.push_back(lower);
            events.ends.push_back(upper);
        }
    }
    parallel_sort(events.starts);
    parallel_sort(events.ends);
    parallel_sort(events.planars);
    return events;
}

// Walks through the events of one kind: counts those passed.
class EventCursor {
public:
    explicit EventCursor(std::span<const float> positions) noexcept : positions_(positions) {}

    [[nodiscard]] float next() const noexcept {
        return passed_ < positions_.size() ? positions_[passed_] : Aabb::infinity;
    }

    // Passes all events at `position`, the next of all kinds; returns how many.
    std::size_t pass(float position) noexcept {
        const std::size_t before = passed_;
        while (passed_ < positions_.size() && positions_[passed_] == position)
            ++passed_;
        return passed_ - before;
    }

private:
    std::span<const float> positions_;
    std::size_t passed_ = 0;
};

std::optional<Split> sweep_axis(const SplitQuery& query, Axis axis) {
    const Events events = sorted_events(query.fragments, axis);
    const PlaneEvaluator evaluator(query.box, axis, query.cost);
    EventCursor starts(events.starts);
    EventCursor ends(events.ends);
    EventCursor planars(events.planars);

    std::optional<Split> best;
    SplitCounts counts{0, query.fragments.size(), 0};
    for (;;) {
        // Never -0: which of equal zeros comes first depends on how the sort was divided.
        const float position = std::min({starts.next(), ends.next(), planars.next()}) + 0.0F;
        if (position == Aabb::infinity) return best;
        // At the plane: what ends here is below it, what starts here is above.
        counts.above -= ends.pass(position);
        counts.in_plane = planars.pass(position);
        counts.above -= counts.in_plane;
        if (evaluator.is_inside(position)) {
            const Split split = evaluator.evaluate(position, counts);
            if (!best || split.cost < best->cost) best = split;
        }
        counts.below += starts.pass(position) + counts.in_plane;
    }
}

}  // namespace

std::optional<Split> SahSweep::find(const SplitQuery& query) const {
    std::optional<Split> best;
    Axis axis = query.box.longest_axis();
    for (std::size_t tried = 0; tried < all_axes.size(); ++tried, axis = next_axis(axis)) {
        const auto split = sweep_axis(query, axis);
        if (split && (!best || split->cost < best->cost)) best = split;
        if (best && best->cost < query.acceptable_cost) return best;
    }
    return best;
}

}  // namespace coppice
