#pragma once

#include "coppice/builders/split_finder.h"

#include "builders/kd/exact/event.h"

#include <array>
#include <cstddef>
#include <functional>
#include <vector>

namespace coppice::inline v0 {

/// The events of one axis.
using EventList = std::vector<EventKey>;

/// A node of the event builder: its PrimRefs, and the sorted events of each axis.
struct ExactNode {
    std::vector<PrimRef> prim_refs;
    std::array<EventList, 3> events;

    /// The capacity of all arrays in bytes.
    [[nodiscard]] std::uint64_t capacity_bytes() const noexcept {
        std::uint64_t bytes = prim_refs.capacity() * sizeof(PrimRef);
        for (const EventList& list : events) {
            bytes += list.capacity() * sizeof(EventKey);
        }
        return bytes;
    }
};

/// Adds the events of a PrimRef on an axis: its start and end, or a single planar event if it is
/// flat there.
void add_events(const PrimRef& prim_ref, std::uint32_t slot, Axis axis, EventList& events);

/// Makes a node with these PrimRefs and sorts its events. Throws Error(limit) for 2^30 of them or
/// more.
[[nodiscard]] ExactNode make_exact_node(std::vector<PrimRef> prim_refs);

/// Calls `work(axis)` for all axes, in parallel if there are many PrimRefs.
void for_each_axis(std::size_t prim_ref_count, const std::function<void(Axis)>& work);

}  // namespace coppice::inline v0
