#include "builders/split/sort_key.h"

#include <gtest/gtest.h>

#include <array>
#include <limits>

namespace coppice::test {
namespace {

TEST(SortKey, KeepsPositionAndWeight) {
    for (const float position : {-3e38F, -1.5F, -1e-45F, 0.0F, 1e-45F, 7.0F, 3e38F}) {
        for (const float weight : {1.0F, 100.25F}) {
            EXPECT_EQ(position_of(sort_key(position, weight)), position);
            EXPECT_EQ(weight_of(sort_key(position, weight)), weight);
        }
    }
}

TEST(SortKey, SortsByPositionThenWeight) {
    constexpr std::array positions{
        -std::numeric_limits<float>::max(), -1.0F, -1e-45F, 0.0F, 1e-45F, 1.0F,
        std::numeric_limits<float>::max()};
    for (std::size_t i = 0; i + 1 < positions.size(); ++i) {
        EXPECT_LT(sort_key(positions[i], 9.0F), sort_key(positions[i + 1], 1.0F));
        EXPECT_LT(sort_key(positions[i], 1.0F), sort_key(positions[i], 9.0F));
    }
}

TEST(SortKey, KnowsOneZero) {
    EXPECT_EQ(sort_key(-0.0F, 1.0F), sort_key(0.0F, 1.0F));
}

}  // namespace
}  // namespace coppice::test
