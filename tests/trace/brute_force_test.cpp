#include "coppice/trace/brute_force.h"

#include "support/meshes.h"
#include "support/rays.h"

#include <gtest/gtest.h>

#include <limits>

namespace coppice::test {
namespace {

// Three parallel triangles at z = 3, 1, 2, around the z axis.
TriangleMesh make_stack() {
    TriangleMesh mesh;
    for (const float z : {3.0F, 1.0F, 2.0F}) {
        add_triangle(mesh, {Vec3f{-1, -1, z}, Vec3f{3, -1, z}, Vec3f{-1, 3, z}});
    }
    return mesh;
}

TEST(BruteForce, MissesNothingThere) {
    EXPECT_FALSE(brute_force_intersect({}, {{0, 0, 0}, {0, 0, 1}}).has_value());
    EXPECT_FALSE(brute_force_occluded({}, {{0, 0, 0}, {0, 0, 1}}));
}

TEST(BruteForce, FindsTheClosest) {
    const TriangleMesh mesh = make_stack();
    const auto up = brute_force_intersect(mesh.view(), {{0, 0, 0}, {0, 0, 1}});
    ASSERT_TRUE(up.has_value());
    EXPECT_EQ(up->prim, 1U);
    EXPECT_EQ(up->t, 1.0F);
    EXPECT_EQ(up->u, 0.25F);
    const auto down = brute_force_intersect(mesh.view(), {{0, 0, 9}, {0, 0, -1}});
    ASSERT_TRUE(down.has_value());
    EXPECT_EQ(down->prim, 0U);
    const auto beyond = brute_force_intersect(mesh.view(), {{0, 0, 0}, {0, 0, 1}, 1.5F});
    ASSERT_TRUE(beyond.has_value());
    EXPECT_EQ(beyond->prim, 2U);
}

TEST(BruteForce, PrefersTheLowestIdOfEquals) {
    const TriangleMesh mesh = repeated(make_stack(), 5);
    const auto hit = brute_force_intersect(mesh.view(), {{0, 0, 0}, {0, 0, 1}});
    ASSERT_TRUE(hit.has_value());
    EXPECT_EQ(hit->prim, 5U);
}

TEST(BruteForce, IsOccludedWithinTheRangeOnly) {
    const TriangleMesh mesh = make_stack();
    EXPECT_TRUE(brute_force_occluded(mesh.view(), {{0, 0, 0}, {0, 0, 1}}));
    EXPECT_TRUE(brute_force_occluded(mesh.view(), {{0, 0, 0}, {0, 0, 1}, 2.5F}));
    EXPECT_FALSE(brute_force_occluded(mesh.view(), {{0, 0, 0}, {0, 0, 1}, 3.5F}));
    EXPECT_FALSE(brute_force_occluded(mesh.view(), {{0, 0, 0}, {0, 0, 1}, 0, 0.5F}));
    EXPECT_FALSE(brute_force_occluded(mesh.view(), {{0, 0, 0}, {0, 0, -1}}));
}

TEST(BruteForce, HitsNothingWithBadRays) {
    const TriangleMesh mesh = make_stack();
    constexpr float nan = std::numeric_limits<float>::quiet_NaN();
    for (const Ray& ray : {Ray{{0, 0, 0}, {0, 0, 0}}, Ray{{nan, 0, 0}, {0, 0, 1}},
                           Ray{{0, 0, 0}, {0, 0, 1}, 5, 1}, Ray{{0, 0, 0}, {0, 0, 1}, 0, -1}}) {
        EXPECT_FALSE(brute_force_intersect(mesh.view(), ray).has_value());
        EXPECT_FALSE(brute_force_occluded(mesh.view(), ray));
    }
}

TEST(BruteForce, OccludedAgreesWithIntersect) {
    const TriangleMesh mesh = make_soup(100, 0.3F, 4);
    const KdTree no_tree;
    RaySource rays(mesh, no_tree, 5);
    for (int i = 0; i < 200; ++i) {
        for (const RayKind kind : all_ray_kinds) {
            const Ray ray = rays.next(kind);
            EXPECT_EQ(brute_force_occluded(mesh.view(), ray),
                      brute_force_intersect(mesh.view(), ray).has_value());
        }
    }
}

}  // namespace
}  // namespace coppice::test
