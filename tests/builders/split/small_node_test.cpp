#include "builders/split/small_node.h"

#include "builders/prim_refs.h"
#include "builders/split/axis_sweep.h"
#include "builders/split/best_split.h"

#include <gtest/gtest.h>

namespace coppice::test {
namespace {

TEST(FindInSmallNode, FindsWhatSweepsFind_9) {
    Random random(9);
    const SahCostModel model{.traversal = 1.5, .intersection = 2.0, .empty_bonus = 0.3};
    for (const Layout layout :
         {Layout::random, Layout::grid, Layout::planar, Layout::points, Layout::identical}) {
        for (int round = 0; round < 200; ++round) {
            auto prim_refs = make_prim_refs(layout, 1 + random.below(small_node_size), random);
            if (round % 2 == 1) prim_refs.back().weight = 100.5F;
            const SplitQuery query{prim_refs, unit_cube, model, 0.0};
            BestSplit best;
            for (const Axis axis : all_axes) {
                if (const auto split = sweep_axis(query, axis)) best.offer(*split);
            }
            const auto found = find_in_small_node(query);
            ASSERT_EQ(found.has_value(), best.get().has_value());
            if (!found) continue;
            EXPECT_EQ(found->plane, best.get()->plane);
            EXPECT_EQ(found->planar_side, best.get()->planar_side);
            EXPECT_EQ(found->cost, best.get()->cost);
        }
    }
}

}  // namespace
}  // namespace coppice::test
