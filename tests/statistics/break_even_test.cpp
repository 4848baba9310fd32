#include "statistics/break_even.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace coppice::lab {

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

TEST(BreakEven, IsWhereBothTakeTheSameTime) {
    const TimeToImage quick{0.5, 4e-7};
    const TimeToImage good{2.0, 1e-7};
    const auto at = break_even(quick, good);
    ASSERT_TRUE(at);
    EXPECT_DOUBLE_EQ(*at, 5e6);
    EXPECT_DOUBLE_EQ(quick.seconds(*at), good.seconds(*at));
    EXPECT_EQ(at, break_even(good, quick));
}

TEST(BreakEven, IsNowhereIfOneIsNotSlowerInEither) {
    EXPECT_FALSE(break_even({1.0, 1.0}, {2.0, 2.0}));
    EXPECT_FALSE(break_even({1.0, 1.0}, {2.0, 1.0}));
    EXPECT_FALSE(break_even({1.0, 1.0}, {1.0, 2.0}));
    EXPECT_FALSE(break_even({1.0, 1.0}, {1.0, 1.0}));
}

TEST(BestSpans, FollowTheLowerEnvelope) {
    // 1 is never the fastest, 4 is worse than 0, 3 is slower to build than the equal ray of 2.
    const std::vector<TimeToImage> trees{{1.0, 8.0}, {5.0, 7.0}, {3.0, 4.0},
                                         {9.0, 4.0}, {2.0, 9.0}, {11.0, 2.0}};
    const auto spans = best_spans(trees);
    ASSERT_EQ(spans.size(), 3U);
    EXPECT_EQ(spans[0].index, 0U);
    EXPECT_EQ(spans[1].index, 2U);
    EXPECT_EQ(spans[2].index, 5U);
    EXPECT_EQ(spans[0].from, 0.0);
    EXPECT_EQ(spans[0].to, 0.5);
    EXPECT_EQ(spans[1].to, 4.0);
    EXPECT_EQ(spans[2].to, infinity);
    for (double count = 0.0; count < 10.0; count += 0.25) {
        const double chosen = trees[span_at(spans, count).index].seconds(count);
        for (const TimeToImage& tree : trees) {
            EXPECT_LE(chosen, tree.seconds(count)) << count;
        }
    }
}

TEST(BestSpans, TakeTheFirstOfEqualTreesAndTheFasterOfThoseBuiltAtOnce) {
    EXPECT_TRUE(best_spans({}).empty());
    const std::vector<TimeToImage> trees{{1.0, 3.0}, {1.0, 2.0}, {1.0, 2.0}};
    const auto spans = best_spans(trees);
    ASSERT_EQ(spans.size(), 1U);
    EXPECT_EQ(spans[0].index, 1U);
    EXPECT_EQ(spans[0].to, infinity);
    EXPECT_EQ(span_at(spans, infinity).index, 1U);
}

TEST(BestSpans, OfThoseThatOvertakeAtOncePassTheSlowerOver) {
    const std::vector<TimeToImage> trees{{0.0, 3.0}, {1.0, 2.0}, {2.0, 1.0}};
    const auto spans = best_spans(trees);
    ASSERT_EQ(spans.size(), 2U);
    EXPECT_EQ(spans[1].index, 2U);
    EXPECT_EQ(spans[1].from, 1.0);
}

}  // namespace

}  // namespace coppice::lab
