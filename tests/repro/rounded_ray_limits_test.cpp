// A hit counts by its t rounded to float, but the traversal cut the ray at t_min and t_max as they
// are: a hit rounded onto a limit was found by brute force only.

#include "coppice/builders/build_tree.h"
#include "coppice/trace/brute_force.h"
#include "coppice/trace/intersect.h"

#include "support/meshes.h"

#include <gtest/gtest.h>

#include <utility>

namespace coppice::test {
namespace {

TEST(RoundedRayLimits, HitsRoundedOntoThemCount) {
    const auto at_z = [](float z) {
        return make_triangle({Vec3f{-1, -1, z}, Vec3f{3, -1, z}, Vec3f{-1, 3, z}});
    };
    // t = 1/3, which rounds up, and t = 0.7, which rounds down.
    for (const auto& [z, length] : {std::pair(1.0F, 3.0F), std::pair(7.0F, 10.0F)}) {
        const TriangleMesh mesh = at_z(z);
        const Ray ray{{0, 0, 0}, {0, 0, length}};
        const KdTree tree = build_kd_tree(mesh.view()).tree;
        const auto hit = brute_force_intersect(mesh.view(), ray);
        ASSERT_TRUE(hit.has_value());
        for (const auto& [t_min, t_max] :
             {std::pair(0.0F, hit->t), std::pair(hit->t, Aabb::infinity),
              std::pair(hit->t, hit->t)}) {
            const Ray limited{ray.origin, ray.direction, t_min, t_max};
            EXPECT_TRUE(brute_force_occluded(mesh.view(), limited));
            EXPECT_TRUE(intersect(tree, mesh.view(), limited).has_value());
            EXPECT_TRUE(occluded(tree, mesh.view(), limited));
        }
    }
}

}  // namespace
}  // namespace coppice::test
