#include "coppice/geom/point_cloud.h"

#include "coppice/geom/primitive_set.h"

#include "support/random.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <tuple>

namespace coppice::test {
namespace {

static_assert(PrimitiveSet<PointCloudView>);

bool precedes(Vec3f a, Vec3f b) {
    return std::tie(a.x, a.y, a.z) < std::tie(b.x, b.y, b.z);
}

std::vector<Vec3f> sorted(std::vector<Vec3f> points) {
    std::sort(points.begin(), points.end(), precedes);
    return points;
}

std::vector<Vec3f> numbered_points(std::uint32_t count) {
    std::vector<Vec3f> points;
    for (std::uint32_t i = 0; i < count; ++i) {
        points.push_back({static_cast<float>(i), 0, 0});
    }
    return points;
}

TEST(PointCloudView, IsEmptyByDefault) {
    EXPECT_EQ(PointCloudView{}.size(), 0U);
}

TEST(PointCloudView, SeesThePoints) {
    const std::vector<Vec3f> points{{1, 2, 3}, {4, 5, 6}};
    const PointCloudView view(points);
    EXPECT_EQ(view.size(), 2U);
    EXPECT_EQ(view.points().data(), points.data());
    EXPECT_EQ(view.bounds(1), (Aabb{{4, 5, 6}, {4, 5, 6}}));
}

TEST(PointCloudView, ClipsToAllOrNothing) {
    const std::vector<Vec3f> points{{1, 2, 3}};
    const PointCloudView view(points);
    EXPECT_EQ(view.clipped_bounds(0, {{0, 0, 0}, {1, 2, 3}}), view.bounds(0));
    EXPECT_EQ(view.clipped_bounds(0, view.bounds(0)), view.bounds(0));
    EXPECT_TRUE(view.clipped_bounds(0, {{0, 0, 0}, {1, 2, 2.9F}}).is_empty());
    EXPECT_TRUE(view.clipped_bounds(0, Aabb{}).is_empty());
}

TEST(ShuffledDistinctPoints, OfNothingIsNothing) {
    EXPECT_TRUE(shuffled_distinct_points({}, 1).empty());
}

TEST(ShuffledDistinctPoints, KeepsEveryPositionOnce) {
    Random random(3);
    std::vector<Vec3f> points;
    for (int i = 0; i < 3000; ++i) {
        points.push_back({static_cast<float>(random.below(10)),
                          static_cast<float>(random.below(10)),
                          static_cast<float>(random.below(10))});
    }
    std::vector<Vec3f> expected = sorted(points);
    expected.erase(std::unique(expected.begin(), expected.end()), expected.end());
    ASSERT_LT(expected.size(), points.size());
    EXPECT_EQ(sorted(shuffled_distinct_points(points, 5)), expected);
}

TEST(ShuffledDistinctPoints, KeepsPointsThatShareSomeCoordinates) {
    const std::vector<Vec3f> points{{1, 1, 1}, {1, 1, 2}, {1, 2, 1}, {2, 1, 1}, {1, 1, 1}};
    EXPECT_THAT(shuffled_distinct_points(points, 1),
                testing::UnorderedElementsAre(Vec3f{1, 1, 1}, Vec3f{1, 1, 2}, Vec3f{1, 2, 1},
                                              Vec3f{2, 1, 1}));
}

TEST(ShuffledDistinctPoints, TakesBothZerosAsOne) {
    std::vector<Vec3f> points;
    for (unsigned signs = 0; signs < 8; ++signs) {
        points.push_back({(signs & 1U) != 0 ? -0.0F : 0.0F, (signs & 2U) != 0 ? -0.0F : 0.0F,
                          (signs & 4U) != 0 ? -0.0F : 0.0F});
    }
    for (int i = 0; i < 8; ++i) {
        std::rotate(points.begin(), points.begin() + 1, points.end());
        const auto distinct = shuffled_distinct_points(points, 1);
        ASSERT_EQ(distinct.size(), 1U);
        // Always the same zero, whatever came first.
        for (const Axis axis : all_axes) {
            EXPECT_FALSE(std::signbit(distinct[0][axis]));
        }
    }
}

TEST(ShuffledDistinctPoints, DoesNotMergeTheSmallestNumbersWithZero) {
    const std::vector<Vec3f> points{{0, 0, 0}, {1e-45F, 0, 0}, {-1e-45F, 0, 0}};
    EXPECT_EQ(shuffled_distinct_points(points, 1).size(), 3U);
}

TEST(ShuffledDistinctPoints, DependsOnTheSeedAlone) {
    const std::vector<Vec3f> points = numbered_points(1000);
    std::vector<Vec3f> backwards = points;
    std::reverse(backwards.begin(), backwards.end());
    const auto shuffled = shuffled_distinct_points(points, 7);
    EXPECT_EQ(shuffled_distinct_points(points, 7), shuffled);
    EXPECT_EQ(shuffled_distinct_points(backwards, 7), shuffled);
    EXPECT_NE(shuffled_distinct_points(points, 8), shuffled);
    EXPECT_NE(shuffled, points);
}

TEST(ShuffledDistinctPoints, GivesAllOrdersAlike) {
    // 24 orders of 4 points in 12,000 shuffles: 500 each, with a standard deviation of 22.
    const std::vector<Vec3f> points = numbered_points(4);
    std::map<std::array<float, 4>, int> counts;
    for (std::uint64_t seed = 0; seed < 12'000; ++seed) {
        const auto shuffled = shuffled_distinct_points(points, seed);
        ++counts[{shuffled[0].x, shuffled[1].x, shuffled[2].x, shuffled[3].x}];
    }
    EXPECT_EQ(counts.size(), 24U);
    for (const auto& [order, count] : counts) {
        EXPECT_NEAR(count, 500, 110);
    }
}

TEST(ShuffledDistinctPoints, PutsEveryPointEverywhere) {
    constexpr std::uint32_t count = 16;
    const std::vector<Vec3f> points = numbered_points(count);
    std::array<std::array<int, count>, count> seen{};
    for (std::uint64_t seed = 0; seed < 16'000; ++seed) {
        const auto shuffled = shuffled_distinct_points(points, seed);
        for (std::size_t place = 0; place < count; ++place) {
            ++seen[static_cast<std::size_t>(shuffled[place].x)][place];
        }
    }
    for (const auto& places : seen) {
        for (const int times : places) {
            EXPECT_NEAR(times, 1000, 160);
        }
    }
}

}  // namespace
}  // namespace coppice::test
