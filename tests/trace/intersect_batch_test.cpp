#include "coppice/base/error.h"
#include "coppice/builders/build_tree.h"
#include "coppice/trace/intersect.h"

#include "support/meshes.h"
#include "support/random.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <vector>

namespace coppice::test {
namespace {

std::vector<Ray> make_rays(std::size_t count) {
    Random random(5);
    std::vector<Ray> rays(count);
    for (Ray& ray : rays) {
        ray = {2.0F * to_float(random.direction()), to_float(random.direction())};
    }
    return rays;
}

TEST(IntersectBatch, IsWhatSingleRaysAre) {
    const TriangleMesh mesh = make_sphere(20, 21);
    const KdTree tree = build_kd_tree(mesh.view()).tree;
    const std::vector<Ray> rays = make_rays(3000);
    constexpr std::size_t room = 3;
    for (const int threads : {1, 2, 0}) {
        std::vector<Hit> hits(rays.size());
        std::vector<std::uint8_t> is_occluded(rays.size(), 7);
        std::vector<Hit> all(room * rays.size());
        std::vector<std::size_t> found(rays.size());
        std::vector<std::size_t> counts(rays.size());
        intersect(tree, mesh.view(), rays, hits, threads);
        occluded(tree, mesh.view(), rays, is_occluded, threads);
        intersect_all(tree, mesh.view(), rays, all, found, threads);
        count_hits(tree, mesh.view(), rays, counts, threads);
        for (std::size_t i = 0; i < rays.size(); ++i) {
            std::array<Hit, room> expected;
            ASSERT_EQ(hits[i], intersect(tree, mesh.view(), rays[i]).value_or(Hit{})) << i;
            ASSERT_EQ(is_occluded[i], occluded(tree, mesh.view(), rays[i]) ? 1 : 0) << i;
            ASSERT_EQ(found[i], intersect_all(tree, mesh.view(), rays[i], expected)) << i;
            ASSERT_TRUE(std::equal(expected.begin(), expected.begin() + found[i],
                                   all.begin() + static_cast<std::ptrdiff_t>(room * i)));
            ASSERT_EQ(counts[i], count_hits(tree, mesh.view(), rays[i])) << i;
        }
    }
}

TEST(IntersectBatch, RefusesSpansThatDoNotFit) {
    const TriangleMesh mesh = make_sphere(4, 5);
    const KdTree tree = build_kd_tree(mesh.view()).tree;
    const std::vector<Ray> rays = make_rays(10);
    std::vector<Hit> hits(19);
    std::vector<std::size_t> found(10);
    std::vector<std::size_t> counts(9);
    std::array<std::uint8_t, 11> is_occluded{};
    EXPECT_THROW(intersect(tree, mesh.view(), rays, hits), Error);
    EXPECT_THROW(occluded(tree, mesh.view(), rays, is_occluded), Error);
    EXPECT_THROW(intersect_all(tree, mesh.view(), rays, hits, found), Error);
    EXPECT_THROW(count_hits(tree, mesh.view(), rays, counts), Error);
    hits.resize(20);
    EXPECT_THROW(intersect_all(tree, mesh.view(), rays, hits, std::span(found).first(9)), Error);
    EXPECT_THROW(intersect_all(tree, mesh.view(), rays, hits, found, -1), Error);
    EXPECT_NO_THROW(intersect_all(tree, mesh.view(), rays, hits, found));
    const std::span<const Ray> none;
    EXPECT_NO_THROW(intersect_all(tree, mesh.view(), none, {}, {}));
}

}  // namespace
}  // namespace coppice::test
