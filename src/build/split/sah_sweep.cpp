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
#include "build/split/sort_key.h"

#include <algorithm>
#include <limits>
#include <vector>

namespace coppice {
namespace {

// The positions of a node's events on one axis with their weights, each kind sorted.
struct Events {
    std::vector<std::uint64_t> starts;
    std::vector<std::uint64_t> ends;
    std::vector<std::uint64_t> planars;
};

Events sorted_events(std::span<const Fragment> fragments, Axis axis) {
    Events events;
    events.starts.reserve(fragments.size());
    events.ends.reserve(fragments.size());
    for (const Fragment& fragment : fragments) {
        const float lower = fragment.box.lower[axis];
        const float upper = fragment.box.upper[axis];
        if (lower == upper) {
            events.planars.push_back(sort_key(lower, fragment.weight));
        } else {
            events.starts.push_back(sort_key(lower, fragment.weight));
            events.ends.push_back(sort_key(upper, fragment.weight));
        }
    }
    parallel_sort(events.starts);
    parallel_sort(events.ends);
    parallel_sort(events.planars);
    return events;
}

// Walks through the events of one kind.
class EventCursor {
public:
    explicit EventCursor(std::span<const std::uint64_t> keys) noexcept : keys_(keys) {}

    [[nodiscard]] float next() const noexcept {
        return passed_ < keys_.size() ? position_of(keys_[passed_]) : Aabb::infinity;
    }

    // Passes all events at `position`, the next of all kinds; returns their weight.
    double pass(float position) noexcept {
        double weight = 0.0;
        while (passed_ < keys_.size() && position_of(keys_[passed_]) == position)
            weight += weight_of(keys_[passed_++]);
        return weight;
    }

private:
    std::span<const std::uint64_t> keys_;
    std::size_t passed_ = 0;
};

std::optional<Split> sweep_axis(const SplitQuery& query, Axis axis) {
    const Events events = sorted_events(query.fragments, axis);
    const PlaneEvaluator evaluator(query.box, axis, query.cost);
    EventCursor starts(events.starts);
    EventCursor ends(events.ends);
    EventCursor planars(events.planars);

    std::optional<Split> best;
    SplitCounts counts{0.0, weight_of(query.fragments), 0.0};
    for (;;) {
        const float position = std::min({starts.next(), ends.next(), planars.next()});
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
