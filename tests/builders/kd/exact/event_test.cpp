#include "builders/kd/exact/event.h"

#include <gtest/gtest.h>

namespace coppice::test {
namespace {

TEST(EventKey, KeepsWhatItIsMadeOf) {
    for (const float position : {-3e38F, -1.0F, 0.0F, 2.5F, 3e38F}) {
        for (const EventKind kind : {EventKind::end, EventKind::planar, EventKind::start}) {
            for (const std::uint32_t slot : {0U, 17U, max_event_slots - 1}) {
                const EventKey event = event_key(position, kind, slot);
                EXPECT_EQ(position_of(event), position);
                EXPECT_EQ(kind_of(event), kind);
                EXPECT_EQ(slot_of(event), slot);
                EXPECT_EQ(with_slot(event, 5), event_key(position, kind, 5));
            }
        }
    }
}

TEST(EventKey, SortsByPositionKindAndSlot) {
    EXPECT_LT(event_key(1.0F, EventKind::start, 9), event_key(2.0F, EventKind::end, 0));
    EXPECT_LT(event_key(1.0F, EventKind::end, 9), event_key(1.0F, EventKind::planar, 0));
    EXPECT_LT(event_key(1.0F, EventKind::planar, 9), event_key(1.0F, EventKind::start, 0));
    EXPECT_LT(event_key(1.0F, EventKind::start, 0), event_key(1.0F, EventKind::start, 1));
    EXPECT_EQ(event_key(-0.0F, EventKind::end, 1), event_key(0.0F, EventKind::end, 1));
}

}  // namespace
}  // namespace coppice::test
