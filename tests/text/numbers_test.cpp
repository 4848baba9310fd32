#include "text/numbers.h"

#include <gtest/gtest.h>

#include <cmath>

namespace coppice::lab {

namespace {

TEST(Numbers, FixedTextHasSoManyDecimals) {
    EXPECT_EQ(fixed_text(1.25, 1), "1.2");
    EXPECT_EQ(fixed_text(3.0, 0), "3");
    EXPECT_EQ(fixed_text(std::nullopt, 2), "-");
    EXPECT_EQ(fixed_text(std::nan(""), 2), "-");
}

TEST(Numbers, CountTextHasTheRightNoun) {
    EXPECT_EQ(count_text(0, "thread"), "0 threads");
    EXPECT_EQ(count_text(1, "thread"), "1 thread");
    EXPECT_EQ(count_text(2, "run"), "2 runs");
}

TEST(Numbers, GroupedTextHasACommaBeforeEveryThirdDigit) {
    EXPECT_EQ(grouped_text(0), "0");
    EXPECT_EQ(grouped_text(999), "999");
    EXPECT_EQ(grouped_text(1000), "1,000");
    EXPECT_EQ(grouped_text(1234567), "1,234,567");
}

TEST(Numbers, SecondsTextHasFewerDecimalsForLongerTimes) {
    EXPECT_EQ(seconds_text(0.00123), "0.001230");
    EXPECT_EQ(seconds_text(1.5), "1.5000");
    EXPECT_EQ(seconds_text(123.45), "123.5");
    EXPECT_EQ(seconds_text(2e6), "2e+06");
}

}  // namespace

}  // namespace coppice::lab
