#include "coppice/trace/intersect.h"

#include "coppice/builders/build_tree.h"
#include "coppice/trace/brute_force.h"

#include "support/effort.h"
#include "support/meshes.h"
#include "support/rays.h"
#include "support/scene_matrix.h"

#include <gtest/gtest.h>

#include <limits>
#include <sstream>
#include <string>
#include <tuple>

namespace coppice::test {
namespace {

std::string description(const Ray& ray) {
    std::ostringstream text;
    text << std::hexfloat << "{{" << ray.origin.x << ", " << ray.origin.y << ", " << ray.origin.z
         << "}, {" << ray.direction.x << ", " << ray.direction.y << ", " << ray.direction.z << "}, "
         << ray.t_min << ", " << ray.t_max << "}";
    return text.str();
}

std::string description(const std::optional<Hit>& hit) {
    if (!hit) return "no hit";
    std::ostringstream text;
    text << std::hexfloat << "triangle " << hit->prim << " at " << hit->t;
    return text.str();
}

// Compares a tree with brute force on one ray.
testing::AssertionResult agrees(const KdTree& tree, TriangleMeshView mesh, const Ray& ray) {
    const auto expected = brute_force_intersect(mesh, ray);
    const auto found = intersect(tree, mesh, ray);
    const bool is_same_hit =
        expected.has_value() == found.has_value() &&
        (!expected || (expected->t == found->t && expected->u == found->u &&
                       expected->v == found->v && expected->prim == found->prim));
    if (!is_same_hit) {
        return testing::AssertionFailure() << description(ray) << ": " << description(found)
                                           << " instead of " << description(expected);
    }
    if (occluded(tree, mesh, ray) != expected.has_value()) {
        return testing::AssertionFailure() << description(ray) << ": occluded() is wrong";
    }
    return testing::AssertionSuccess();
}

using SceneAndRule = std::tuple<NamedScene, std::string>;

class IntersectScene : public testing::TestWithParam<SceneAndRule> {};

testing::AssertionResult agrees_for_all_kinds(const KdTree& tree, const TriangleMesh& mesh) {
    const int ray_count = effort(mesh.triangles.size() > 900 ? 6 : 24);
    RaySource rays(mesh, tree, 31);
    for (const RayKind kind : all_ray_kinds) {
        for (int i = 0; i < ray_count; ++i) {
            auto result = agrees(tree, mesh.view(), rays.next(kind));
            if (!result) return result << ", " << name_of(kind) << " " << i;
        }
    }
    return testing::AssertionSuccess();
}

TEST_P(IntersectScene, EqualsBruteForceForAllKindsOfRays) {
    const auto& [scene, rule] = GetParam();
    const TriangleMesh mesh = scene.make();
    for (const double rate : {1.0, 0.3, 0.02}) {
        for (const LeafRefinement leaf_refinement : {LeafRefinement::none, LeafRefinement::kd}) {
            const KdTree tree = build_kd_tree(mesh.view(), {.sample = {.rate = rate},
                                                            .split = {.rule = rule, .max_leaf = 3},
                                                            .leaf_refinement = leaf_refinement})
                                    .tree;
            EXPECT_TRUE(agrees_for_all_kinds(tree, mesh))
                << "rate " << rate << ", growth " << name_of(leaf_refinement);
        }
    }
}

std::string scene_and_rule_name(const testing::TestParamInfo<SceneAndRule>& info) {
    const auto& [scene, rule] = info.param;
    return std::string(scene.name) + "_" + rule;
}

INSTANTIATE_TEST_SUITE_P(Seed31, IntersectScene,
                         testing::Combine(testing::ValuesIn(scene_matrix()),
                                          testing::Values("sah", "median", "midpoint")),
                         scene_and_rule_name);

TEST(Intersect, HitsNothingWithBadRays) {
    const TriangleMesh mesh = make_sphere(10, 10);
    const KdTree tree = build_kd_tree(mesh.view()).tree;
    constexpr float nan = std::numeric_limits<float>::quiet_NaN();
    constexpr float infinity = std::numeric_limits<float>::infinity();
    const Ray good{{0, 0, 0}, {0.1F, 0.2F, 1}};
    ASSERT_TRUE(intersect(tree, mesh.view(), good).has_value());
    std::vector<Ray> bad_rays{{{0, 0, 0}, {0, 0, 0}},       {{0, 0, 0}, {-0.0F, 0, -0.0F}},
                              {{0, 0, 0}, {0, 0, 1}, 2, 1}, {{0, 0, 0}, {0, 0, 1}, -5, -1},
                              {{0, 0, 0}, {0, 0, 1}, nan},  {{0, 0, 0}, {0, 0, 1}, 0, nan}};
    for (const float bad : {nan, infinity, -infinity}) {
        for (const Axis axis : all_axes) {
            bad_rays.insert(bad_rays.end(), 2, good);
            bad_rays.back().origin[axis] = bad;
            bad_rays[bad_rays.size() - 2].direction[axis] = bad;
        }
    }
    for (const Ray& ray : bad_rays) {
        EXPECT_FALSE(intersect(tree, mesh.view(), ray).has_value()) << description(ray);
        EXPECT_FALSE(occluded(tree, mesh.view(), ray)) << description(ray);
        EXPECT_TRUE(agrees(tree, mesh.view(), ray));
    }
}

TEST(Intersect, LooksBehindTheOriginIfAskedTo) {
    const TriangleMesh mesh = make_soup(300, 0.2F, 6);
    const KdTree tree = build_kd_tree(mesh.view()).tree;
    RaySource rays(mesh, tree, 7);
    for (int i = 0; i < 2000; ++i) {
        Ray ray = rays.next(RayKind::between_points);
        ray.t_min = i % 2 == 0 ? -std::numeric_limits<float>::infinity() : -0.7F;
        ASSERT_TRUE(agrees(tree, mesh.view(), ray));
    }
}

TEST(Intersect, TakesRaysOfAnyLengthAndPlace) {
    const TriangleMesh mesh = make_soup(300, 0.2F, 6);
    const KdTree tree = build_kd_tree(mesh.view()).tree;
    RaySource rays(mesh, tree, 9);
    Random random(10);
    for (int i = 0; i < 600; ++i) {
        Ray ray = rays.next(RayKind::at_triangle);
        const float factor = std::exp2(static_cast<float>(random.below(250)) - 125.0F);
        ray.direction = factor * ray.direction;
        ASSERT_TRUE(agrees(tree, mesh.view(), ray)) << i;
        ray = rays.next(RayKind::at_triangle);
        ray.origin = ray.origin - std::exp2(static_cast<float>(random.below(120))) * ray.direction;
        ASSERT_TRUE(agrees(tree, mesh.view(), ray)) << i;
    }
}

// Origins close to a plane of the tree, directions almost within it.
TEST(Intersect, TakesRaysThatHardlyLeaveAPlane) {
    const TriangleMesh mesh = make_boxes(3);
    const KdTree tree = build_kd_tree(mesh.view()).tree;
    RaySource rays(mesh, tree, 12);
    Random random(13);
    for (int i = 0; i < 2000; ++i) {
        Ray ray = rays.next(RayKind::in_split_plane);
        const auto axis = static_cast<Axis>(random.below(3));
        const auto tiny = [&] {
            const float size = std::exp2(-static_cast<float>(random.below(140)));
            return random.below(2) == 0 ? size : -size;
        };
        ray.direction[axis] += tiny();
        if (random.below(2) == 0) ray.origin[axis] += tiny();
        ASSERT_TRUE(agrees(tree, mesh.view(), ray)) << i;
    }
}

}  // namespace
}  // namespace coppice::test
