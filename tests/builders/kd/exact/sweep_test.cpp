#include "builders/kd/exact/sweep.h"

#include "builders/prim_refs.h"
#include "builders/split/exact_split.h"

#include <gtest/gtest.h>

namespace coppice::test {
namespace {

TEST(Sweep, FindsWhatExactSplitFinds_6) {
    Random random(6);
    const SahCostModel model{.traversal = 1.5, .intersection = 2.0, .empty_bonus = 0.3};
    for (const Layout layout :
         {Layout::random, Layout::grid, Layout::planar, Layout::points, Layout::identical}) {
        for (int round = 0; round < 50; ++round) {
            auto prim_refs = make_prim_refs(layout, 1 + random.below(200), random);
            if (round % 2 == 1) prim_refs.front().weight = 4.5F;
            const double weight = weight_of(prim_refs);
            const auto expected = ExactSplit().find({prim_refs, unit_cube, model, 0.0});
            const auto found = sweep(make_exact_node(prim_refs), unit_cube, weight, model);
            ASSERT_EQ(found.has_value(), expected.has_value());
            if (!found) continue;
            EXPECT_EQ(found->plane, expected->plane);
            EXPECT_EQ(found->planar_side, expected->planar_side);
            EXPECT_EQ(found->cost, expected->cost);
        }
    }
}

}  // namespace
}  // namespace coppice::test
