#include "build/split/binned_split.h"

#include "build/fragments.h"
#include "build/split/exact_split.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace coppice::test {
namespace {

TEST(BinnedSplit, IsExactInSmallNodes_2) {
    Random random(2);
    for (int round = 0; round < 100; ++round) {
        const auto fragments = make_fragments(Layout::random, 1 + random.below(64), random);
        const SplitQuery query{fragments, unit_cube, {}, 0.0};
        const auto exact = ExactSplit().find(query);
        const auto binned = BinnedSplit().find(query);
        ASSERT_EQ(binned.has_value(), exact.has_value());
        if (!binned) continue;
        EXPECT_EQ(binned->plane, exact->plane);
    }
}

TEST(BinnedSplit, ComesNearTheExactCostInLargeNodes_5) {
    Random random(5);
    for (const Layout layout : {Layout::random, Layout::grid, Layout::planar, Layout::points}) {
        for (int round = 0; round < 20; ++round) {
            auto fragments = make_fragments(layout, 65 + random.below(5000), random);
            const SplitQuery query{fragments, unit_cube, {}, 0.0};
            const auto exact = ExactSplit().find(query);
            const auto binned = BinnedSplit().find(query);
            ASSERT_TRUE(exact && binned);
            EXPECT_GE(binned->cost, exact->cost);
            EXPECT_LE(binned->cost, 1.15 * exact->cost);
            std::reverse(fragments.begin(), fragments.end());
            EXPECT_EQ(BinnedSplit().find(query)->plane, binned->plane) << "order does not matter";
        }
    }
}

TEST(BinnedSplit, CutsOffEmptySpaceExactly) {
    Random random(6);
    auto fragments = make_fragments(Layout::random, 500, random);
    for (Fragment& fragment : fragments) {
        fragment.box.lower.x = 0.7F + 0.2F * fragment.box.lower.x;
        fragment.box.upper.x = 0.7F + 0.2F * fragment.box.upper.x;
    }
    const SplitQuery query{fragments, unit_cube, {}, 0.0};
    EXPECT_EQ(BinnedSplit().find(query)->plane, ExactSplit().find(query)->plane);
}

TEST(BinnedSplit, WorksAtScalesWhereFloatsOverflow) {
    Random random(7);
    for (const float scale : {1e-42F, 1e-35F, 1e-30F, 1e30F, 3e38F}) {
        auto fragments = make_fragments(Layout::random, 200, random);
        for (Fragment& fragment : fragments) {
            fragment.box = {scale * fragment.box.lower, scale * fragment.box.upper};
        }
        const Aabb box{{0, 0, 0}, {scale, scale, scale}};
        const auto split = BinnedSplit().find({fragments, box, {}, 0.0});
        ASSERT_TRUE(split.has_value()) << scale;
        EXPECT_GT(split->plane.position, 0.0F);
        EXPECT_LT(split->plane.position, scale);
    }
}

}  // namespace
}  // namespace coppice::test
