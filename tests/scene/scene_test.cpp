#include "coppice/scene/scene.h"

#include "coppice/base/error.h"
#include "coppice/builders/build_tree.h"
#include "coppice/io/load_mesh.h"
#include "coppice/trace/brute_force.h"

#include "support/meshes.h"
#include "support/rays.h"
#include "support/tree_checks.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <filesystem>
#include <type_traits>
#include <utility>

namespace coppice::test {
namespace {

static_assert(std::is_move_constructible_v<Scene>);
static_assert(!std::is_convertible_v<TriangleMesh, Scene>, "building is never implicit");

TEST(Scene, TracesWhatItWasGiven) {
    const TriangleMesh mesh = make_soup(500, 0.1F, 1);
    const Scene scene(mesh);
    EXPECT_EQ(scene.mesh().triangles, mesh.triangles);
    const KdTree planes = build_kd_tree(mesh.view()).tree;
    RaySource rays(mesh, planes, 2);
    for (int i = 0; i < 300; ++i) {
        const Ray ray = rays.next(i % 2 == 0 ? RayKind::at_triangle : RayKind::line);
        const auto expected = brute_force_intersect(mesh.view(), ray);
        const auto hit = scene.intersect(ray);
        ASSERT_EQ(hit.has_value(), expected.has_value());
        EXPECT_EQ(scene.occluded(ray), expected.has_value());
        if (hit) {
            EXPECT_EQ(hit->t, expected->t);
            EXPECT_EQ(hit->prim, expected->prim);
        }
    }
}

TEST(Scene, TracesManyRaysAndAllHits) {
    const Scene scene(make_sphere(20, 30));
    const std::array rays{Ray{{0.01F, 0.02F, -3}, {0, 0, 1}}, Ray{{5, 5, -3}, {0, 0, 1}}};
    std::array<Hit, 2> hits;
    scene.intersect(rays, hits);
    EXPECT_EQ(hits[0], scene.intersect(rays[0]));
    EXPECT_TRUE(hits[0].is_hit());
    EXPECT_EQ(hits[1], Hit{});
    EXPECT_FALSE(hits[1].is_hit());
    EXPECT_THROW(scene.intersect(rays, hits, -1), Error);
    std::array<std::uint8_t, 2> is_occluded{7, 7};
    scene.occluded(rays, is_occluded, 2);
    EXPECT_EQ(is_occluded, (std::array<std::uint8_t, 2>{1, 0}));
    EXPECT_EQ(scene.count_hits(rays[0]), 2U) << "in and out";
    EXPECT_EQ(scene.intersect_all(rays[0], hits), 2U);
    EXPECT_LT(hits[0].t, hits[1].t);
    std::array<Hit, 1> behind;
    EXPECT_EQ(scene.intersect_all(rays[0], behind, &hits[0]), 1U);
    EXPECT_EQ(behind[0], hits[1]);
}

TEST(Scene, BuildsByItsOptions) {
    const TriangleMesh mesh = make_soup(500, 0.1F, 1);
    const Bvh8Options options{.sample = {.rate = 0.1, .seed = 3}, .sampled_from = 0};
    const Scene scene(mesh, options);
    EXPECT_TRUE(is_same(scene.tree(), build_bvh8(mesh.view(), options).tree));
    EXPECT_TRUE(is_sound(scene.tree(), scene.mesh().view()));
    EXPECT_EQ(scene.build_report().sample.rate, 0.1);
    EXPECT_EQ(scene.build_report().primitive_count, 500U);
    EXPECT_EQ(scene.build_report().sample_count, 50U);
    EXPECT_EQ(scene.build_report().statistics.inner_count, scene.tree().nodes().size());
}

TEST(Scene, SearchesWhatItWasGiven) {
    const Scene scene(make_sphere(20, 30));
    const Vec3f inside{0.1F, 0.2F, 0.3F};
    const SurfaceNeighbor nearest = scene.nearest(inside);
    EXPECT_NEAR(nearest.distance(), 1.0 - std::sqrt(0.14), 0.02);
    std::array<SurfaceNeighbor, 3> found;
    EXPECT_EQ(scene.nearest_k(inside, found), 3U);
    EXPECT_EQ(found.front().prim, nearest.prim);
    std::size_t count = 0;
    scene.for_each_within({0, 0, 0}, 1.0F, [&](const SurfaceNeighbor&) { ++count; });
    EXPECT_EQ(count, scene.mesh().triangles.size());
    scene.for_each_overlapping({{2, 0, 0}, {3, 1, 1}}, [&](std::uint32_t) { ++count; });
    EXPECT_EQ(count, scene.mesh().triangles.size());
    const SignedDistance distance = Scene(scene).make_signed_distance();
    EXPECT_EQ(distance.nearest(inside).signed_distance, -nearest.distance());
    EXPECT_THROW((void)Scene(make_soup(5, 0.1F, 1)).make_signed_distance(), Error);
}

TEST(Scene, OfNothingIsHitByNothing) {
    const Scene scene{TriangleMesh{}};
    EXPECT_FALSE(scene.intersect({{0, 0, 0}, {0, 0, 1}}).has_value());
    EXPECT_FALSE(scene.occluded({{0, 0, 0}, {0, 0, 1}}));
}

TEST(Scene, ChecksItsOptions) {
    EXPECT_THROW(Scene(make_soup(5, 0.1F, 1), {.sample = {.rate = 2.0}}), Error);
}

TEST(Scene, MovesAndCopies) {
    const Ray ray{.origin = {0.1F, 0.2F, 0}, .direction = {0, 0, 1}};
    Scene scene(make_sphere(20, 20));
    const auto expected = scene.intersect(ray);
    ASSERT_TRUE(expected.has_value());
    const Scene copy = scene;
    Scene moved = std::move(scene);
    EXPECT_EQ(moved.intersect(ray)->t, expected->t);
    EXPECT_EQ(copy.intersect(ray)->t, expected->t);
    Scene assigned(make_soup(5, 0.1F, 1));
    assigned = std::move(moved);
    EXPECT_EQ(assigned.intersect(ray)->prim, expected->prim);
    EXPECT_EQ(assigned.build_report().primitive_count, 760U);
}

// The whole program of the architecture's first page.
TEST(Scene, IsAllThatANewcomerNeeds) {
    const Scene scene(load_mesh(std::filesystem::path(COPPICE_TEST_DATA_DIR) / "bunny.obj"),
                      {.sample = {.rate = 0.05}});
    const Ray ray{.origin = {0, 0, -5}, .direction = {0, 0, 1}};
    const auto hit = scene.intersect(ray);
    ASSERT_TRUE(hit.has_value());
    EXPECT_GT(hit->t, 0.0F);
    EXPECT_LT(hit->t, 6.0F);
    const auto expected = brute_force_intersect(scene.mesh().view(), ray);
    ASSERT_TRUE(expected.has_value());
    EXPECT_EQ(hit->prim, expected->prim);
}

TEST(BunnyObj, IsClosed) {
    LoadReport report;
    const Scene scene(
        load_mesh(std::filesystem::path(COPPICE_TEST_DATA_DIR) / "bunny.obj", &report));
    EXPECT_EQ(report.zero_area_triangles.count, 0U);
    EXPECT_EQ(report.duplicate_vertices.count, 0U);
    EXPECT_EQ(report.unused_vertices.count, 0U);
    Random random(6);
    for (int i = 0; i < 2000; ++i) {
        EXPECT_TRUE(scene.intersect({{0, 0, 0}, to_float(random.direction())}).has_value());
    }
}

}  // namespace
}  // namespace coppice::test
