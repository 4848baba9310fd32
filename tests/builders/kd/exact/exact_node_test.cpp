#include "builders/kd/exact/exact_node.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <mutex>
#include <set>

namespace coppice::test {
namespace {

using testing::ElementsAre;

TEST(MakeExactNode, SortsTheEventsOfEachAxis) {
    const ExactNode node =
        make_exact_node({{{{2, 0, 0}, {3, 1, 1}}, 10}, {{{0, 0, 0}, {2, 0, 1}}, 11}});
    EXPECT_THAT(node.events[0],
                ElementsAre(event_key(0, EventKind::start, 1), event_key(2, EventKind::end, 1),
                            event_key(2, EventKind::start, 0), event_key(3, EventKind::end, 0)));
    EXPECT_THAT(node.events[1],
                ElementsAre(event_key(0, EventKind::planar, 1), event_key(0, EventKind::start, 0),
                            event_key(1, EventKind::end, 0)));
    EXPECT_EQ(node.events[2].size(), 4U);
}

TEST(ForEachAxis, CallsAllOnce) {
    for (const std::size_t count : {std::size_t{1}, std::size_t{1'000'000}}) {
        std::mutex mutex;
        std::multiset<Axis> axes;
        for_each_axis(count, [&](Axis axis) {
            const std::lock_guard lock(mutex);
            axes.insert(axis);
        });
        EXPECT_THAT(axes, ElementsAre(Axis::x, Axis::y, Axis::z));
    }
}

}  // namespace
}  // namespace coppice::test
