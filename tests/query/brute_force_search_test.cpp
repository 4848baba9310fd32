#include "coppice/query/brute_force_search.h"

#include "support/meshes.h"

#include <gtest/gtest.h>

#include <array>

namespace coppice::test {
namespace {

constexpr std::array corners{Vec3f{3, 0, 0}, Vec3f{1, 0, 0}, Vec3f{-1, 0, 0}, Vec3f{1, 0, 0}};

TEST(BruteForceSearch, OrdersByDistanceThenId) {
    const auto found = brute_force_within(PointCloudView(corners), {0, 0, 0}, 1.0F);
    ASSERT_EQ(found.size(), 3U);
    EXPECT_EQ(found[0].prim, 1U);
    EXPECT_EQ(found[1].prim, 2U);
    EXPECT_EQ(found[2].prim, 3U);
    EXPECT_EQ(found[2].distance(), 1.0);
    EXPECT_TRUE(found[2].is_found());
    EXPECT_FALSE(Neighbor{}.is_found());
    EXPECT_EQ(brute_force_within(PointCloudView(corners), {0, 0, 0}).size(), 4U);
    EXPECT_TRUE(brute_force_within(PointCloudView(corners), {0, 0, 0}, -1.0F).empty());
}

TEST(BruteForceSearch, FindsTriangles) {
    const TriangleMesh mesh = make_sheet(2, {0, 0, 0}, {1, 0, 0}, {0, 1, 0});
    const auto found = brute_force_within(mesh.view(), {1, 1, 2}, 2.0F);
    EXPECT_EQ(found.size(), 6U) << "all but the two beyond the diagonals";
    EXPECT_EQ(found.front().point, (Vec3f{1, 1, 0}));
    EXPECT_EQ(brute_force_overlapping(mesh.view(), {{0, 0, 0}, {0, 0, 0}}).size(), 2U);
}

TEST(BruteForceSearch, FindsPointsInBoxes) {
    const std::vector<std::uint32_t> expected{0, 1, 3};
    EXPECT_EQ(brute_force_overlapping(PointCloudView(corners), {{1, 0, 0}, {3, 0, 0}}), expected);
}

}  // namespace
}  // namespace coppice::test
