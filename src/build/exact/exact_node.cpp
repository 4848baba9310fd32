#include "build/exact/exact_node.h"

#include "coppice/base/error.h"
#include "coppice/base/parallel.h"

#include "build/stop_look.h"

#include <fmt/format.h>

namespace coppice {

void add_events(const Fragment& fragment, std::uint32_t slot, Axis axis, EventList& events) {
    const float lower = fragment.box.lower[axis];
    const float upper = fragment.box.upper[axis];
    if (lower == upper) {
        events.push_back(event_key(lower, EventKind::planar, slot));
    } else {
        events.push_back(event_key(lower, EventKind::start, slot));
        events.push_back(event_key(upper, EventKind::end, slot));
    }
}

ExactNode make_exact_node(std::vector<Fragment> fragments) {
    if (fragments.size() >= max_event_slots) {
        throw Error(ErrorCode::limit,
                    fmt::format("{} primitives are too many for exact construction; at most {}",
                                fragments.size(), max_event_slots - 1));
    }
    ExactNode node{std::move(fragments), {}};
    for_each_axis(node.fragments.size(), [&](Axis axis) {
        EventList& events = node.events[static_cast<std::size_t>(axis)];
        events.reserve(2 * node.fragments.size());
        StopLook look;
        for (std::uint32_t slot = 0; slot < node.fragments.size(); ++slot) {
            look.at(slot);
            add_events(node.fragments[slot], slot, axis, events);
        }
        parallel_sort(events);
    });
    return node;
}

void for_each_axis(std::size_t fragment_count, const std::function<void(Axis)>& work) {
    constexpr std::size_t parallel_count = 16384;
    if (fragment_count < parallel_count) {
        for (const Axis axis : all_axes) {
            work(axis);
        }
    } else {
        parallel_for_chunks(all_axes.size(), 1,
                            [&](std::size_t begin, std::size_t) { work(all_axes[begin]); });
    }
}

}  // namespace coppice
