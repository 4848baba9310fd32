#include "verify/exact_judge.h"

#include "coppice/trace/brute_force.h"

#include "support/meshes.h"
#include "support/random.h"
#include "support/rays.h"
#include "support/scene_matrix.h"
#include "verify/exact_hit.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace coppice::lab {

namespace {

using coppice::test::make_soup;
using coppice::test::Random;
using coppice::test::ray_through;

const Triangle unit{Vec3f{0, 0, 1}, Vec3f{1, 0, 1}, Vec3f{0, 1, 1}};

TEST(ExactDistance, CountsEdgesAndCornersFromBothSides) {
    const Vec3f up{0, 0, 1};
    for (const Vec3f& from :
         {Vec3f{0, 0, 0}, Vec3f{0.5F, 0, 0}, Vec3f{0.5F, 0.5F, 0}, Vec3f{0.25F, 0.25F, 0}}) {
        EXPECT_EQ(exact_distance({from, up}, unit), 1.0);
        EXPECT_EQ(exact_distance({from, {0, 0, -0.5F}}, unit), -2.0) << "limits are ignored";
        EXPECT_TRUE(may_meet({from, up}, unit));
    }
}

TEST(ExactDistance, RoundsNothing) {
    constexpr float tiny = std::numeric_limits<float>::denorm_min();
    const Vec3f up{0, 0, 1};
    EXPECT_FALSE(exact_distance({{-tiny, 0, 0}, up}, unit).has_value());
    EXPECT_TRUE(exact_distance({{tiny, 0, 0}, up}, unit).has_value());
    EXPECT_FALSE(exact_distance({{0.5F, 0.5F, 0}, {tiny, 0, 1}}, unit).has_value());
    EXPECT_TRUE(may_meet({{0.5F, 0.5F, 0}, {tiny, 0, 1}}, unit)) << "double cannot tell";
    EXPECT_FALSE(may_meet({{0.5F, 0.75F, 0}, up}, unit));
}

TEST(ExactDistance, TakesLinesInThePlaneForMisses) {
    EXPECT_FALSE(exact_distance({{-1, 0.25F, 1}, {1, 0, 0}}, unit).has_value());
    EXPECT_FALSE(exact_distance({{0, 0, 0}, {0, 0, 1}}, {unit[0], unit[0], unit[0]}).has_value());
}

// The library's test of one triangle decides as exact arithmetic does, on all the scenes and rays
// that are hard to decide.
TEST(ExactDistance, IsWhatTheLibraryDecides) {
    for (const auto& scene : coppice::test::scene_matrix()) {
        const TriangleMesh mesh = scene.make();
        const KdTree no_tree;
        coppice::test::RaySource rays(mesh, no_tree, 13);
        for (const auto kind : coppice::test::all_ray_kinds) {
            Ray ray = rays.next(kind);
            ray.t_min = -std::numeric_limits<float>::infinity();
            ray.t_max = std::numeric_limits<float>::infinity();
            if (!is_traceable(ray)) continue;
            for (std::uint32_t id = 0; id < std::min(500U, mesh.view().size()); ++id) {
                const Triangle triangle = mesh.view().triangle(id);
                const auto exact =
                    may_meet(ray, triangle) ? exact_distance(ray, triangle) : std::nullopt;
                const bool is_in_range =
                    exact && std::abs(*exact) <= std::numeric_limits<float>::max();
                const auto hit = intersect_triangle(ray, triangle);
                ASSERT_EQ(hit.has_value(), is_in_range) << scene.name << " " << name_of(kind);
                if (!hit) continue;
                ASSERT_FLOAT_EQ(hit->t, static_cast<float>(*exact)) << scene.name;
            }
        }
    }
}

TEST(ExactJudge, AgreesWithBruteForceOffTheEdges) {
    const TriangleMesh mesh = make_soup(400, 0.3F, 3);
    const ExactJudge judge(mesh.view());
    Random random(4);
    const Aabb box{{0, 0, 0}, {1, 1, 1}};
    for (int i = 0; i < 300; ++i) {
        Ray ray = ray_through(random.in_box(box), random.in_box(box));
        if (i % 3 == 0) ray.t_max = 0.2F;
        const auto expected = brute_force_intersect(mesh.view(), ray);
        const auto found = judge.closest(ray, {});
        ASSERT_EQ(found.has_value(), expected.has_value());
        if (!found) continue;
        EXPECT_EQ(found->prim, expected->prim);
        EXPECT_FLOAT_EQ(static_cast<float>(found->t), expected->t);
    }
    EXPECT_FALSE(judge.closest({{0, 0, 0}, {0, 0, 0}}, {}).has_value());
}

}  // namespace

}  // namespace coppice::lab
