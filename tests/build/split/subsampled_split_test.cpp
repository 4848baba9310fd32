#include "build/split/subsampled_split.h"

#include "build/fragments.h"
#include "build/split/exact_split.h"

#include <gtest/gtest.h>

namespace coppice::test {
namespace {

TEST(SubsampledSplit, IsPricedWithAllFragments_3) {
    Random random(3);
    for (const std::uint32_t count : {65U, 1024U, 20'000U}) {
        const auto fragments = make_fragments(Layout::random, count, random);
        const SahCostModel model;
        const auto split = SubsampledSplit().find({fragments, unit_cube, model, 0.0});
        ASSERT_TRUE(split.has_value());
        const double expected =
            naive_split_cost(fragments, unit_cube, model, split->plane, split->planar_side);
        EXPECT_NEAR(split->cost, expected, 1e-9 * expected);
    }
}

TEST(SubsampledSplit, SeesWhatStandsOut) {
    std::vector<Fragment> fragments;
    for (std::uint32_t id = 0; id < 10'000; ++id) {
        const float x = id % 2 == 0 ? 0.0F : 0.9F;
        fragments.push_back({{{x, 0, 0}, {x + 0.1F, 1, 1}}, id});
    }
    const SahCostModel model;
    const SplitQuery query{fragments, unit_cube, model, 0.0};
    const auto split = SubsampledSplit().find(query);
    ASSERT_TRUE(split.has_value());
    EXPECT_LT(split->cost, 1.1 * ExactSplit().find(query)->cost);
}

}  // namespace
}  // namespace coppice::test
