#pragma once

#include "builders/split/sort_key.h"

#include <cstdint>

namespace coppice::inline v0 {

/// The kinds of events, in the order in which a sweep processes events at the same position.
enum class EventKind : std::uint8_t { end = 0, planar = 1, start = 2 };

/// An end of a PrimRef on an axis as one number that sorts by position, then kind, then PrimRef. A
/// PrimRef is identified by its slot, its index among the node's PrimRefs; position_of() gives the
/// position.
using EventKey = std::uint64_t;

inline constexpr unsigned event_slot_bits = 30;
inline constexpr std::uint32_t max_event_slots = 1U << event_slot_bits;

/// Makes an event; slot < max_event_slots.
[[nodiscard]] inline EventKey event_key(float position, EventKind kind,
                                        std::uint32_t slot) noexcept {
    return sort_key(position, 0.0F) | static_cast<EventKey>(kind) << event_slot_bits | slot;
}

[[nodiscard]] inline EventKind kind_of(EventKey event) noexcept {
    return static_cast<EventKind>(event >> event_slot_bits & 3U);
}

[[nodiscard]] inline std::uint32_t slot_of(EventKey event) noexcept {
    return static_cast<std::uint32_t>(event) & (max_event_slots - 1);
}

/// The same event with another slot.
[[nodiscard]] inline EventKey with_slot(EventKey event, std::uint32_t slot) noexcept {
    return (event & ~EventKey{max_event_slots - 1}) | slot;
}

}  // namespace coppice::inline v0
