#include "statistics/mean.h"
#include "statistics/median.h"
#include "statistics/percentile.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <vector>

namespace coppice::lab {

namespace {

TEST(Median, IsInTheMiddleOrBetweenTheTwoInTheMiddle) {
    EXPECT_EQ(median_of({7.0}), 7.0);
    EXPECT_EQ(median_of({9.0, 1.0, 5.0}), 5.0);
    EXPECT_EQ(median_of({9.0, 1.0}), 5.0);
    EXPECT_EQ(median_of({8.0, 100.0, 1.0, 4.0}), 6.0);
}

TEST(Percentile, IsTheNearestRank) {
    const std::vector<std::uint32_t> one{3};
    for (const std::size_t percent : {0U, 1U, 50U, 100U}) {
        EXPECT_EQ(percentile_of(one, percent), 3U);
    }
    const std::vector<std::uint32_t> four{10, 20, 30, 40};
    EXPECT_EQ(percentile_of(four, 0), 10U);
    EXPECT_EQ(percentile_of(four, 25), 10U);
    EXPECT_EQ(percentile_of(four, 26), 20U);
    EXPECT_EQ(percentile_of(four, 50), 20U);
    EXPECT_EQ(percentile_of(four, 99), 40U);
    EXPECT_EQ(percentile_of(four, 100), 40U);
}

TEST(Mean, IsComputedInDouble) {
    EXPECT_EQ(mean_of(std::vector<float>{1.0F, 2.0F, 6.0F}), 3.0);
    EXPECT_EQ(mean_of(std::vector<float>(3, 1e38F)), double{1e38F});  // the sum passes a float
}

}  // namespace

}  // namespace coppice::lab
