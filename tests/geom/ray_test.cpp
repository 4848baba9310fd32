#include "coppice/geom/ray.h"

#include "support/numbers.h"

#include <gtest/gtest.h>

namespace coppice::test {
namespace {

constexpr Ray good{.origin = {1, 2, 3}, .direction = {0, 0, -1}};

TEST(IsTraceable, AcceptsRaysOfAllLengths) {
    EXPECT_TRUE(is_traceable(good));
    EXPECT_TRUE(is_traceable({{0, 0, 0}, {1e-45F, 0, 0}}));
    EXPECT_TRUE(is_traceable({{3e38F, -3e38F, 3e38F}, {3e38F, 3e38F, 3e38F}}));
    EXPECT_TRUE(is_traceable({{0, 0, 0}, {1, 0, 0}, -5, 0}));
    EXPECT_TRUE(is_traceable({{0, 0, 0}, {1, 0, 0}, -infinity, infinity}));
    EXPECT_TRUE(is_traceable({{0, 0, 0}, {1, 0, 0}, 2, 2}));
    EXPECT_TRUE(is_traceable({{0, 0, 0}, {1, 0, 0}, -1, -0.0F}));
}

TEST(IsTraceable, RefusesZeroDirections) {
    EXPECT_FALSE(is_traceable({{0, 0, 0}, {0, 0, 0}}));
    EXPECT_FALSE(is_traceable({{0, 0, 0}, {-0.0F, 0, -0.0F}}));
}

TEST(IsTraceable, RefusesWhatIsNotFinite) {
    for (const float bad : {nan, infinity, -infinity}) {
        for (const Axis axis : all_axes) {
            Ray ray = good;
            ray.origin[axis] = bad;
            EXPECT_FALSE(is_traceable(ray));
            ray = good;
            ray.direction[axis] = bad;
            EXPECT_FALSE(is_traceable(ray));
        }
    }
}

TEST(IsTraceable, RefusesEmptyIntervals) {
    EXPECT_FALSE(is_traceable({{0, 0, 0}, {1, 0, 0}, 2, 1}));
    EXPECT_FALSE(is_traceable({{0, 0, 0}, {1, 0, 0}, -2, -1}));
    EXPECT_FALSE(is_traceable({{0, 0, 0}, {1, 0, 0}, nan, 1}));
    EXPECT_FALSE(is_traceable({{0, 0, 0}, {1, 0, 0}, 0, nan}));
}

}  // namespace
}  // namespace coppice::test
