#include "coppice/scene/point_scene.h"

#include "coppice/base/error.h"
#include "coppice/query/brute_force_search.h"

#include "support/meshes.h"
#include "support/random.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

namespace coppice::test {
namespace {

TEST(PointScene, FindsWhatBruteForceFinds_Seed3) {
    const std::vector<Vec3f> points = make_soup(3000, 0.1F, 2).vertices;
    const PointScene scene(points);
    Random random(3);
    for (int i = 0; i < 100; ++i) {
        const Vec3f at = random.in_box({{0, 0, 0}, {1, 1, 1}});
        const auto expected = brute_force_within(PointCloudView(points), at, 0.1F);
        std::vector<Neighbor> found(expected.size() + 1);
        ASSERT_EQ(scene.nearest_k(at, found, 0.1F), expected.size());
        for (std::size_t k = 0; k < expected.size(); ++k) {
            ASSERT_EQ(found[k].prim, expected[k].prim);
        }
        EXPECT_EQ(scene.nearest(at).prim, expected.front().prim);
        std::size_t count = 0;
        scene.for_each_within(at, 0.1F, [&](const Neighbor&) { ++count; });
        EXPECT_EQ(count, expected.size());
    }
}

TEST(PointScene, HasLeavesOfSomeTens) {
    const PointScene scene(make_terrain(200, 4).vertices);
    EXPECT_EQ(scene.build_report().primitive_count, 201U * 201U);
    EXPECT_EQ(scene.points().size(), 201U * 201U);
    std::uint32_t most = 0;
    for (const KdNode& node : scene.tree().nodes()) {
        if (node.is_leaf()) most = std::max(most, node.reference_count());
    }
    EXPECT_LT(most, 512U);
    EXPECT_GT(most, 31U);
}

TEST(PointScene, TakesPointsVeryFarAway) {
    std::vector<Vec3f> points = make_terrain(100, 4).vertices;
    points.push_back({1e30F, -1e30F, 1e25F});
    const PointScene scene(points);
    EXPECT_EQ(std::get<KdOptions>(scene.build_report().options).split.rule, "median");
    for (const KdNode& node : scene.tree().nodes()) {
        EXPECT_TRUE(!node.is_leaf() || node.reference_count() < 512U);
    }
    EXPECT_EQ(scene.nearest(points[77]).prim, 77U);
    EXPECT_EQ(scene.nearest({1e29F, 0, 0}).prim, 0U) << "equally far to a double, all but one";
    EXPECT_EQ(PointScene(points, {.split = {.max_leaf = 7}}).tree().bounds(),
              scene.tree().bounds());
}

TEST(PointScene, OfNothingAndOfOne) {
    EXPECT_FALSE(PointScene({}).nearest({0, 0, 0}).is_found());
    const PointScene one({{1, 2, 3}});
    EXPECT_EQ(one.nearest({1, 2, 0}).distance(), 3.0);
    int count = 0;
    one.for_each_overlapping({{0, 0, 0}, {3, 3, 3}}, [&](std::uint32_t id) {
        EXPECT_EQ(id, 0U);
        ++count;
    });
    EXPECT_EQ(count, 1);
    EXPECT_THROW(PointScene({{1, NAN, 3}}), Error);
}

}  // namespace
}  // namespace coppice::test
