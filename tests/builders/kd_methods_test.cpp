// Every k-d method on every scene that breaks builders.

#include "coppice/builders/build_tree.h"
#include "coppice/builders/method.h"
#include "coppice/trace/brute_force.h"
#include "coppice/trace/intersect.h"

#include "support/meshes.h"
#include "support/primitives.h"
#include "support/rays.h"
#include "support/scene_matrix.h"
#include "support/tree_checks.h"

#include <gtest/gtest.h>

#include <string>
#include <tuple>
#include <vector>

namespace coppice::test {
namespace {

std::vector<std::string> kd_method_names() {
    std::vector<std::string> names;
    for (const Method& method : method_registry()) {
        if (method.tree() == TreeKind::kd) names.emplace_back(method.name);
    }
    return names;
}

using SceneAndMethod = std::tuple<NamedScene, std::string>;

class KdMethodMatrix : public testing::TestWithParam<SceneAndMethod> {
protected:
    [[nodiscard]] static TriangleMesh mesh() { return std::get<NamedScene>(GetParam()).make(); }

    [[nodiscard]] static KdOptions options() {
        return find_method(std::get<std::string>(GetParam())).kd_options();
    }
};

TEST_P(KdMethodMatrix, TreesAreSoundAndTheSameForAnyThreads) {
    const Primitives scene(mesh());
    for (const PrimitiveKind kind : {PrimitiveKind::triangles, PrimitiveKind::points}) {
        const PrimitiveSetView primitives = scene.of(kind);
        KdOptions once = options();
        once.threads = 1;
        const KdTree tree = build_kd_tree(primitives, once).tree;
        EXPECT_TRUE(is_sound(tree, primitives));
        EXPECT_TRUE(is_in_order(tree));
        EXPECT_LE(depth_of(tree), once.split.max_depth);
        EXPECT_EQ(distinct_reference_count(tree), primitives.size());
        for (const int threads : {2, 3, 8}) {
            once.threads = threads;
            EXPECT_TRUE(build_kd_tree(primitives, once).tree == tree) << threads << " threads";
        }
    }
}

TEST_P(KdMethodMatrix, HitsAreThoseOfBruteForce) {
    const TriangleMesh scene = mesh();
    const KdTree tree = build_kd_tree(scene.view(), options()).tree;
    RaySource rays(scene, tree, 11);
    for (const RayKind kind : all_ray_kinds) {
        for (int i = 0; i < 8; ++i) {
            const Ray ray = rays.next(kind);
            const auto expected = brute_force_intersect(scene.view(), ray);
            const auto found = intersect(tree, scene.view(), ray);
            ASSERT_EQ(found.has_value(), expected.has_value()) << name_of(kind) << " " << i;
            if (!found) continue;
            EXPECT_EQ(found->t, expected->t) << name_of(kind) << " " << i;
            EXPECT_EQ(found->prim, expected->prim) << name_of(kind) << " " << i;
        }
    }
}

std::string scene_and_method_name(const testing::TestParamInfo<SceneAndMethod>& info) {
    const auto& [scene, method] = info.param;
    return std::string(scene.name) + "_" + method;
}

INSTANTIATE_TEST_SUITE_P(Seed11, KdMethodMatrix,
                         testing::Combine(testing::ValuesIn(scene_matrix()),
                                          testing::ValuesIn(kd_method_names())),
                         scene_and_method_name);

// Scenes large enough for tasks, chunks and bins.
class KdMethodInParallel : public testing::TestWithParam<std::string> {};

TEST_P(KdMethodInParallel, GivesTheSameTreeEveryTime) {
    const TriangleMesh mesh = joined(make_terrain(140, 1), make_soup(2000, 0.2F, 1));
    KdOptions options = find_method(GetParam()).kd_options();
    options.threads = 1;
    const KdTree expected = build_kd_tree(mesh.view(), options).tree;
    EXPECT_TRUE(is_sound(expected, mesh.view()));
    for (const int threads : {2, 3, 8, 0}) {
        options.threads = threads;
        EXPECT_TRUE(build_kd_tree(mesh.view(), options).tree == expected) << threads << " threads";
    }
}

TEST_P(KdMethodInParallel, KeepsDuplicationBounded) {
    const TriangleMesh mesh = make_needles(3000, 2);
    const KdTree tree = build_kd_tree(mesh.view(), find_method(GetParam()).kd_options()).tree;
    EXPECT_TRUE(is_sound(tree, mesh.view()));
    EXPECT_LT(tree.references().size(), 128 * mesh.triangles.size());
}

INSTANTIATE_TEST_SUITE_P(Seed1, KdMethodInParallel, testing::ValuesIn(kd_method_names()),
                         [](const auto& each) { return each.param; });

}  // namespace
}  // namespace coppice::test
