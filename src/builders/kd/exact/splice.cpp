// Makes the children's sorted events without sorting. Each event of the parent is sent to its
// PrimRef's side in order. That keeps them sorted, because slots keep their order, too. Only the
// new events of clipped PrimRefs, few at most nodes, are sorted and merged in. Cost: O(n + m log m)
// for m PrimRefs across the plane.
// Source: [WaldHavran2006] sec. 4.3, steps 2 to 4.

#include "builders/kd/exact/splice.h"

#include "base/cancellation_poll.h"
#include "base/free_memory.h"

#include <algorithm>
#include <array>
#include <span>
#include <utility>

namespace coppice::inline v0 {
namespace {

// Divides the events of an axis between the children, without those of clipped PrimRefs. The lower
// child's reuse the array.
std::array<EventList, 2> divide_events(EventList events, std::size_t above_count,
                                       const std::vector<std::uint32_t>& moved_to) {
    std::array<EventList, 2> sides{std::move(events), EventList(2 * above_count)};
    std::array<EventKey*, 2> ends{sides[0].data(), sides[1].data()};
    CancellationPoll look;
    const std::span<const EventKey> all = sides[0];
    for (std::size_t at = 0; at < all.size(); ++at) {
        look.at(at);
        const EventKey event = all[at];
        const std::uint32_t target = moved_to[slot_of(event)];
        if (target == Classification::moved_anew) continue;
        const std::size_t side = target >> 31;
        *ends[side]++ = with_slot(event, target & ~Classification::in_upper_child);
    }
    for (std::size_t side = 0; side < 2; ++side) {
        sides[side].resize(static_cast<std::size_t>(ends[side] - sides[side].data()));
    }
    // Not shrink_to_fit(), which keeps the whole array, silently, if a smaller one cannot be
    // allocated.
    if (sides[0].size() < sides[0].capacity()) {
        sides[0] = EventList(sides[0].begin(), sides[0].end());
    }
    return sides;
}

// Adds the events of the PrimRefs in these slots.
void merge_new(EventList& events, const std::vector<PrimRef>& prim_refs,
               const std::vector<std::uint32_t>& slots, Axis axis) {
    const auto old_count = static_cast<std::ptrdiff_t>(events.size());
    EventList added;
    added.reserve(2 * slots.size());
    for (const std::uint32_t slot : slots) {
        add_events(prim_refs[slot], slot, axis, added);
    }
    std::sort(added.begin(), added.end());
    // Merges from the back, so that no event is moved twice.
    events.resize(events.size() + added.size());
    auto from = events.begin() + old_count;
    auto to = events.end();
    while (!added.empty()) {
        if (from != events.begin() && *(from - 1) > added.back()) {
            *--to = *--from;
        } else {
            *--to = added.back();
            added.pop_back();
        }
    }
}

}  // namespace

ExactChildren splice(ExactNode&& node, const Classification& classification, Partition&& sides) {
    const std::size_t count = node.prim_refs.size();
    free_memory(node.prim_refs);
    ExactChildren children;
    children.below.prim_refs = std::move(sides.below);
    children.above.prim_refs = std::move(sides.above);
    for_each_axis(count, [&](Axis axis) {
        const auto index = static_cast<std::size_t>(axis);
        auto [below, above] =
            divide_events(std::move(node.events[index]), children.above.prim_refs.size(),
                          classification.moved_to);
        merge_new(below, children.below.prim_refs, classification.clipped_below, axis);
        merge_new(above, children.above.prim_refs, classification.clipped_above, axis);
        children.below.events[index] = std::move(below);
        children.above.events[index] = std::move(above);
    });
    return children;
}

}  // namespace coppice::inline v0
