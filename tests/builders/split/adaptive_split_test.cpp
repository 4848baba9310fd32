#include "builders/split/adaptive_split.h"

#include "builders/prim_refs.h"
#include "builders/split/exact_split.h"

#include <gtest/gtest.h>

namespace coppice::test {
namespace {

TEST(AdaptiveSplit, ComesNearTheExactCost_4) {
    Random random(4);
    for (const Layout layout : {Layout::random, Layout::points}) {
        const auto prim_refs = make_prim_refs(layout, 5000, random);
        const SahCostModel model{.empty_bonus = 0.0};
        const SplitQuery query{prim_refs, unit_cube, model, 0.0};
        const auto split = AdaptiveSplit().find(query);
        ASSERT_TRUE(split.has_value());
        EXPECT_LT(split->cost, 1.2 * ExactSplit().find(query)->cost);
        EXPECT_NEAR(split->cost,
                    naive_split_cost(prim_refs, unit_cube, model, split->plane, split->planar_side),
                    1e-9 * split->cost);
    }
}

// All change is within a hundredth of the node: even planes miss it, adapted ones do not.
TEST(AdaptiveSplit, LooksWhereCountsChange) {
    std::vector<PrimRef> prim_refs;
    for (std::uint32_t id = 0; id < 1000; ++id) {
        const float x = 0.5F + 1e-5F * static_cast<float>(id);
        prim_refs.push_back({{{x, 0, 0}, {x + 1e-5F, 1, 1}}, id});
    }
    const auto split = AdaptiveSplit().find({prim_refs, unit_cube, {.empty_bonus = 0.0}, 0.0});
    ASSERT_TRUE(split.has_value());
    EXPECT_EQ(split->plane.axis, Axis::x);
    EXPECT_GT(split->plane.position, 0.4F);
    EXPECT_LT(split->plane.position, 0.6F);
}

}  // namespace
}  // namespace coppice::test
