#include "builders/kd/exact/exact_node.h"

#include "coppice/base/error.h"
#include "coppice/base/parallel.h"

#include "base/cancellation_poll.h"

#include <fmt/format.h>

namespace coppice::inline v0 {

void add_events(const PrimRef& prim_ref, std::uint32_t slot, Axis axis, EventList& events) {
    const float lower = prim_ref.box.lower[axis];
    const float upper = prim_ref.box.upper[axis];
    if (lower == upper) {
        events.push_back(event_key(lower, EventKind::planar, slot));
    } else {
        events.push_back(event_key(lower, EventKind::start, slot));
        events.push_back(event_key(upper, EventKind::end, slot));
    }
}

ExactNode make_exact_node(std::vector<PrimRef> prim_refs) {
    if (prim_refs.size() >= max_event_slots) {
        throw Error(ErrorCode::limit,
                    fmt::format("{} primitives are too many for exact construction; at most {}",
                                prim_refs.size(), max_event_slots - 1));
    }
    ExactNode node{std::move(prim_refs), {}};
    for_each_axis(node.prim_refs.size(), [&](Axis axis) {
        EventList& events = node.events[static_cast<std::size_t>(axis)];
        events.reserve(2 * node.prim_refs.size());
        CancellationPoll look;
        for (std::uint32_t slot = 0; slot < node.prim_refs.size(); ++slot) {
            look.at(slot);
            add_events(node.prim_refs[slot], slot, axis, events);
        }
        parallel_sort(events);
    });
    return node;
}

void for_each_axis(std::size_t prim_ref_count, const std::function<void(Axis)>& work) {
    constexpr std::size_t parallel_count = 16384;
    if (prim_ref_count < parallel_count) {
        for (const Axis axis : all_axes) {
            work(axis);
        }
    } else {
        parallel_for_chunks(all_axes.size(), 1,
                            [&](std::size_t begin, std::size_t) { work(all_axes[begin]); });
    }
}

}  // namespace coppice::inline v0
