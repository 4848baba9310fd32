#include "coppice/json/sah_cost_model.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace coppice::test {
namespace {

TEST(SahCostModelJson, HasAllConstants) {
    const nlohmann::json json =
        SahCostModel{.traversal = 15, .intersection = 20, .empty_bonus = 0.2};
    EXPECT_EQ(json,
              nlohmann::json({{"traversal", 15.0}, {"intersection", 20.0}, {"empty_bonus", 0.2}}));
}

}  // namespace
}  // namespace coppice::test
