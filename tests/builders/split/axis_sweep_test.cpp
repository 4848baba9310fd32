#include "builders/split/axis_sweep.h"

#include "builders/prim_refs.h"

#include <gtest/gtest.h>

namespace coppice::test {
namespace {

TEST(SweepAxis, FindsTheCheapestEnd_5) {
    Random random(5);
    const SahCostModel model{.empty_bonus = 0.3};
    for (const Layout layout : {Layout::random, Layout::grid, Layout::planar, Layout::points}) {
        const auto prim_refs = make_prim_refs(layout, 60, random);
        const auto split = sweep_axis({prim_refs, unit_cube, model, 0.0}, Axis::z);
        ASSERT_TRUE(split.has_value());
        for (const PrimRef& prim_ref : prim_refs) {
            for (const float end : {prim_ref.box.lower.z, prim_ref.box.upper.z}) {
                if (end <= 0.0F || end >= 1.0F) continue;
                EXPECT_GE(naive_plane_cost(prim_refs, unit_cube, model, {Axis::z, end}),
                          split->cost * (1.0 - 1e-12));
            }
        }
    }
}

}  // namespace
}  // namespace coppice::test
