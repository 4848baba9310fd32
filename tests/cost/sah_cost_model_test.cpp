#include "coppice/cost/sah_cost_model.h"

#include "coppice/base/error.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <string>

namespace coppice::test {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr double infinity = std::numeric_limits<double>::infinity();

std::string error_of(const SahCostModel& model) {
    try {
        require_valid(model);
    } catch (const Error& error) {
        EXPECT_EQ(error.code(), ErrorCode::invalid_argument);
        return error.what();
    }
    return "";
}

TEST(SahCostModel, PricesLeavesAndSplits) {
    const SahCostModel model{.traversal = 3.0, .intersection = 2.0, .empty_bonus = 0.25};
    EXPECT_EQ(model.leaf_cost(5.0), 10.0);
    EXPECT_EQ(model.traversal_cost(), 3.0);
    EXPECT_EQ(model.leaf_cost(0.0), 0.0);
    EXPECT_EQ(model.split_cost(0.5, 4.0, 0.75, 8.0), 3.0 + 2.0 * (0.5 * 4.0 + 0.75 * 8.0));
}

TEST(SahCostModel, RewardsAnEmptySide) {
    const SahCostModel model{.traversal = 3.0, .intersection = 2.0, .empty_bonus = 0.25};
    EXPECT_EQ(model.split_cost(0.5, 0.0, 0.75, 8.0), 3.0 + 2.0 * 0.75 * (0.75 * 8.0));
    EXPECT_EQ(model.split_cost(0.5, 4.0, 0.75, 0.0), 3.0 + 2.0 * 0.75 * (0.5 * 4.0));
    EXPECT_EQ(model.split_cost(0.5, 0.0, 0.75, 0.0), 3.0);
}

TEST(SahCostModel, CountsFractionsOfPrimitives) {
    const SahCostModel model{};
    EXPECT_DOUBLE_EQ(model.split_cost(0.5, 0.25, 0.5, 0.75), 1.5);
}

TEST(CheckSahCostModel, AcceptsItsRanges) {
    EXPECT_EQ(error_of({}), "");
    EXPECT_EQ(error_of({.traversal = 0.0, .intersection = 1e-300, .empty_bonus = 0.0}), "");
    EXPECT_EQ(error_of({.traversal = 1e300, .intersection = 80, .empty_bonus = 0.999}), "");
}

TEST(CheckSahCostModel, NamesWhatIsOutside) {
    for (const double bad : {-1.0, -1e-300, nan, infinity, -infinity}) {
        EXPECT_THAT(error_of({.traversal = bad}),
                    testing::MatchesRegex("traversal cost .* is outside .0, inf."));
    }
    for (const double bad : {0.0, -0.0, -1.0, nan, infinity}) {
        EXPECT_THAT(error_of({.intersection = bad}), testing::StartsWith("intersection cost "));
    }
    for (const double bad : {-0.1, 1.0, 2.0, nan, infinity}) {
        EXPECT_THAT(error_of({.empty_bonus = bad}), testing::StartsWith("empty bonus "));
    }
    EXPECT_EQ(error_of({.empty_bonus = 1.5}), "empty bonus 1.5 is outside [0, 1)");
}

}  // namespace
}  // namespace coppice::test
