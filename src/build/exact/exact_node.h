#pragma once

#include "coppice/build/split_finder.h"

#include "build/exact/event.h"

#include <array>
#include <cstddef>
#include <functional>
#include <vector>

namespace coppice {

/// The events of one axis.
using EventList = std::vector<EventKey>;

/// A node of the event builder: its fragments, and the sorted events of each axis.
struct ExactNode {
    std::vector<Fragment> fragments;
    std::array<EventList, 3> events;

    /// What all arrays have allocated.
    [[nodiscard]] std::uint64_t capacity_bytes() const noexcept {
        std::uint64_t bytes = fragments.capacity() * sizeof(Fragment);
        for (const EventList& list : events) {
            bytes += list.capacity() * sizeof(EventKey);
        }
        return bytes;
    }
};

/// Adds the events of a fragment on an axis: its start and end, or one if it is flat there.
void add_events(const Fragment& fragment, std::uint32_t slot, Axis axis, EventList& events);

/// A node with these fragments. Throws Error(limit) for 2^30 of them or more.
[[nodiscard]] ExactNode make_exact_node(std::vector<Fragment> fragments);

/// Calls `work(axis)` for all axes, in parallel where there are many fragments.
void for_each_axis(std::size_t fragment_count, const std::function<void(Axis)>& work);

}  // namespace coppice
