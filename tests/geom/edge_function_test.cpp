#include "geom/edge_function.h"

#include <gtest/gtest.h>

namespace coppice::test {
namespace {

TEST(EdgeFunction, IsTheVolumeWithItsSign) {
    EXPECT_EQ(edge_function({0, 0, 0}, {0, 0, 2}, {1, 0, 5}, {0, 3, 7}), 6.0);
    EXPECT_EQ(edge_function({0, 0, 0}, {0, 0, 2}, {0, 3, 7}, {1, 0, 5}), -6.0);
    EXPECT_EQ(edge_function({1, 1, 1}, {0, 0, 2}, {2, 1, 6}, {1, 4, 8}), 6.0);
}

TEST(EdgeFunction, IsZeroWhereTheRayMeetsTheEdge) {
    // Numbers of which double rounds all products.
    const auto third = static_cast<double>(1.0F / 3.0F);
    const Vec3d origin{0.1F, -third, 0.7F};
    const Vec3d direction{third, 0.3F, -0.9F};
    const Vec3d on_ray{0.1F + 4.0 * third, -third + 4.0 * 0.3F, 0.7F - 4.0 * 0.9F};
    EXPECT_EQ(edge_function(origin, direction, on_ray, {5, 6, 7}), 0.0);
    EXPECT_EQ(edge_function(origin, direction, {5, 6, 7}, on_ray), 0.0);
}

TEST(EdgeFunction, TellsTheLeastOffsetFromNone) {
    for (const double offset : {0x1.0p-149, 0x1.0p-100, 0x1.0p-60}) {
        for (const double sign : {-1.0, 1.0}) {
            const double volume =
                edge_function({sign * offset, 0, 0}, {0, 0, 1}, {0, -100, 3}, {0, 70, 3e30});
            EXPECT_LT(volume * sign, 0.0) << offset;
        }
    }
}

}  // namespace
}  // namespace coppice::test
