#include "build/split/axis_sweep.h"

#include "build/fragments.h"

#include <gtest/gtest.h>

namespace coppice::test {
namespace {

TEST(SweepAxis, FindsTheCheapestEnd_5) {
    Random random(5);
    const SahCostModel model{.empty_bonus = 0.3};
    for (const Layout layout : {Layout::random, Layout::grid, Layout::planar, Layout::points}) {
        const auto fragments = make_fragments(layout, 60, random);
        const auto split = sweep_axis({fragments, unit_cube, model, 0.0}, Axis::z);
        ASSERT_TRUE(split.has_value());
        for (const Fragment& fragment : fragments) {
            for (const float end : {fragment.box.lower.z, fragment.box.upper.z}) {
                if (end <= 0.0F || end >= 1.0F) continue;
                EXPECT_GE(naive_plane_cost(fragments, unit_cube, model, {Axis::z, end}),
                          split->cost * (1.0 - 1e-12));
            }
        }
    }
}

}  // namespace
}  // namespace coppice::test
