#include "builders/split/axis_events.h"

#include "builders/prim_refs.h"

#include <gtest/gtest.h>

namespace coppice::test {
namespace {

TEST(AxisEvents, KnowPlanarsAndWhatIsLeftOut) {
    AxisEvents events;
    events.add({{{0, 0, 0}, {1, 0, 1}}, 0}, Axis::x);
    events.add({{{0, 0, 0}, {1, 0, 1}}, 1}, Axis::y);
    events.add({{{0, 0, 0}, {1, 1, 1}}, 2}, Axis::z, false, true);
    EXPECT_EQ(events.starts.size(), 1U);
    EXPECT_EQ(events.ends.size(), 2U);
    EXPECT_EQ(events.planars.size(), 1U);
}

TEST(SweepEvents, GoesOnFromCountsBefore) {
    // One PrimRef below the window, one above it, one ends and one starts inside.
    AxisEvents events;
    events.add({{{0, 0, 0}, {0.5F, 1, 1}}, 0}, Axis::x, false, true);
    events.add({{{0.6F, 0, 0}, {1, 1, 1}}, 1}, Axis::x, true, false);
    const SahCostModel model{.empty_bonus = 0.0};
    BestSplit best;
    sweep_events(events, PlaneEvaluator(unit_cube, Axis::x, model), {2.0, 3.0, 0.0}, best);
    ASSERT_TRUE(best.get().has_value());
    // At 0.5: two below, two above; (2 + 4 * 0.5) / 6 of the area each.
    EXPECT_EQ(best.get()->plane, (SplitPlane{Axis::x, 0.5F}));
    EXPECT_DOUBLE_EQ(best.cost(), 1.0 + 2.0 * 4.0 / 6.0 + 2.0 * 4.0 / 6.0);
}

}  // namespace
}  // namespace coppice::test
