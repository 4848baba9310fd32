#include "builders/split/subsampled_split.h"

#include "builders/prim_refs.h"
#include "builders/split/exact_split.h"

#include <gtest/gtest.h>

namespace coppice::test {
namespace {

TEST(SubsampledSplit, IsPricedWithAllFragments_3) {
    Random random(3);
    for (const std::uint32_t count : {65U, 1024U, 20'000U}) {
        const auto prim_refs = make_prim_refs(Layout::random, count, random);
        const SahCostModel model;
        const auto split = SubsampledSplit().find({prim_refs, unit_cube, model, 0.0});
        ASSERT_TRUE(split.has_value());
        const double expected =
            naive_split_cost(prim_refs, unit_cube, model, split->plane, split->planar_side);
        EXPECT_NEAR(split->cost, expected, 1e-9 * expected);
    }
}

TEST(SubsampledSplit, SeesWhatStandsOut) {
    std::vector<PrimRef> prim_refs;
    for (std::uint32_t id = 0; id < 10'000; ++id) {
        const float x = id % 2 == 0 ? 0.0F : 0.9F;
        prim_refs.push_back({{{x, 0, 0}, {x + 0.1F, 1, 1}}, id});
    }
    const SahCostModel model;
    const SplitQuery query{prim_refs, unit_cube, model, 0.0};
    const auto split = SubsampledSplit().find(query);
    ASSERT_TRUE(split.has_value());
    EXPECT_LT(split->cost, 1.1 * ExactSplit().find(query)->cost);
}

}  // namespace
}  // namespace coppice::test
