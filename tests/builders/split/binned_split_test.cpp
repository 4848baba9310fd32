#include "builders/split/binned_split.h"

#include "builders/prim_refs.h"
#include "builders/split/exact_split.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace coppice::test {
namespace {

TEST(BinnedSplit, IsExactInSmallNodes_2) {
    Random random(2);
    for (int round = 0; round < 100; ++round) {
        const auto prim_refs = make_prim_refs(Layout::random, 1 + random.below(64), random);
        const SplitQuery query{prim_refs, unit_cube, {}, 0.0};
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
            auto prim_refs = make_prim_refs(layout, 65 + random.below(5000), random);
            const SplitQuery query{prim_refs, unit_cube, {}, 0.0};
            const auto exact = ExactSplit().find(query);
            const auto binned = BinnedSplit().find(query);
            ASSERT_TRUE(exact && binned);
            EXPECT_GE(binned->cost, exact->cost);
            EXPECT_LE(binned->cost, 1.15 * exact->cost);
            std::reverse(prim_refs.begin(), prim_refs.end());
            EXPECT_EQ(BinnedSplit().find(query)->plane, binned->plane) << "order does not matter";
        }
    }
}

TEST(BinnedSplit, CutsOffEmptySpaceExactly) {
    Random random(6);
    auto prim_refs = make_prim_refs(Layout::random, 500, random);
    for (PrimRef& prim_ref : prim_refs) {
        prim_ref.box.lower.x = 0.7F + 0.2F * prim_ref.box.lower.x;
        prim_ref.box.upper.x = 0.7F + 0.2F * prim_ref.box.upper.x;
    }
    const SplitQuery query{prim_refs, unit_cube, {}, 0.0};
    EXPECT_EQ(BinnedSplit().find(query)->plane, ExactSplit().find(query)->plane);
}

TEST(BinnedSplit, WorksAtScalesWhereFloatsOverflow) {
    Random random(7);
    for (const float scale : {1e-42F, 1e-35F, 1e-30F, 1e30F, 3e38F}) {
        auto prim_refs = make_prim_refs(Layout::random, 200, random);
        for (PrimRef& prim_ref : prim_refs) {
            prim_ref.box = {scale * prim_ref.box.lower, scale * prim_ref.box.upper};
        }
        const Aabb box{{0, 0, 0}, {scale, scale, scale}};
        const auto split = BinnedSplit().find({prim_refs, box, {}, 0.0});
        ASSERT_TRUE(split.has_value()) << scale;
        EXPECT_GT(split->plane.position, 0.0F);
        EXPECT_LT(split->plane.position, scale);
    }
}

}  // namespace
}  // namespace coppice::test
