#include "statistics/confidence.h"

#include "coppice/base/rng.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

namespace coppice::lab {

namespace {

TEST(TQuantile, IsThatOfTheTables) {
    EXPECT_NEAR(t_quantile(1), 12.7062, 5e-5);
    EXPECT_NEAR(t_quantile(2), 4.30265, 5e-6);
    EXPECT_NEAR(t_quantile(3), 3.18245, 5e-6);
    EXPECT_NEAR(t_quantile(4), 2.77645, 5e-6);
    EXPECT_NEAR(t_quantile(9), 2.26216, 5e-6);
    EXPECT_NEAR(t_quantile(30), 2.04227, 5e-6);
    EXPECT_NEAR(t_quantile(120), 1.97993, 5e-6);
    EXPECT_NEAR(t_quantile(999), 1.96234, 5e-6);
}

TEST(MeanInterval, IsThatOfAWorkedExample) {
    const auto interval = mean_interval(std::vector{1.0, 2.0, 3.0, 4.0, 5.0});
    ASSERT_TRUE(interval);
    EXPECT_DOUBLE_EQ(interval->mean, 3.0);
    EXPECT_NEAR(interval->high - 3.0, 2.77645 * std::sqrt(2.5 / 5.0), 1e-5);
    EXPECT_NEAR(interval->low + interval->high, 6.0, 1e-12);
}

TEST(MeanInterval, HasNoWidthForEqualValues) {
    const auto interval = mean_interval(std::vector{0.1, 0.1, 0.1});
    ASSERT_TRUE(interval);
    EXPECT_EQ(interval->mean, 0.1);
    EXPECT_EQ(interval->low, 0.1);
    EXPECT_EQ(interval->high, 0.1);
}

TEST(MeanInterval, IsNothingForOneValueOrOneThatIsNotFinite) {
    EXPECT_FALSE(mean_interval({}));
    EXPECT_FALSE(mean_interval(std::vector{1.0}));
    EXPECT_FALSE(mean_interval(std::vector{1.0, std::numeric_limits<double>::quiet_NaN()}));
}

TEST(MeanInterval, HoldsTheTrueMeanInNineteenOfTwentyCases) {
    int held_count = 0;
    constexpr int case_count = 4000;
    for (std::uint64_t i = 0; i < case_count; ++i) {
        std::vector<double> values;
        for (std::uint64_t k = 0; k < 5; ++k) {
            double sum = 0.0;  // of twelve: nearly normal, around 0
            for (std::uint64_t j = 0; j < 12; ++j) {
                sum += random_unit(7, 60 * i + 12 * k + j) - 0.5;
            }
            values.push_back(sum);
        }
        const auto interval = mean_interval(values);
        held_count += interval->low <= 0.0 && interval->high >= 0.0 ? 1 : 0;
    }
    EXPECT_NEAR(held_count, 0.95 * case_count, 4.0 * std::sqrt(0.95 * 0.05 * case_count));
}

}  // namespace

}  // namespace coppice::lab
