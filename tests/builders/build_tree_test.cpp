// The whole pipeline over the matrix of scenes, kinds of primitives, rules and protocols.

#include "coppice/builders/build_tree.h"

#include "coppice/base/error.h"
#include "coppice/builders/build_on_sample.h"
#include "coppice/builders/draw_sample.h"
#include "coppice/builders/empty_leaves.h"
#include "coppice/builders/refill.h"

#include "support/meshes.h"
#include "support/primitives.h"
#include "support/scene_matrix.h"
#include "support/tree_checks.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <tuple>

namespace coppice::test {
namespace {

// How the leaf limit and the growth go with the rate (METHOD 2).
enum class Protocol { fixed, scaled, grown };

KdOptions options_of(Protocol protocol, double rate) {
    KdOptions options{.sample = {.rate = rate, .seed = 3}, .leaf_refinement = LeafRefinement::none};
    if (protocol != Protocol::fixed) {
        options.split.max_leaf = static_cast<std::uint32_t>(std::max(1.0, std::round(32.0 * rate)));
    }
    if (protocol == Protocol::grown) options.leaf_refinement = LeafRefinement::kd;
    return options;
}

using MatrixCase = std::tuple<NamedScene, std::string, PrimitiveKind>;

class BuildMatrix : public testing::TestWithParam<MatrixCase> {
protected:
    [[nodiscard]] static PrimitiveSetView primitives_of(const Primitives& primitives) {
        return primitives.of(std::get<PrimitiveKind>(GetParam()));
    }

    // All combinations of protocol, clipping and rate.
    template <typename Check>
    static void for_all_options(Check&& check) {
        for (const Protocol protocol : {Protocol::fixed, Protocol::scaled, Protocol::grown}) {
            for (const Clipping clipping : {Clipping::perfect, Clipping::bounding_box}) {
                for (const double rate : {1.0, 0.5, 0.1, 0.01}) {
                    KdOptions options = options_of(protocol, rate);
                    options.split.rule = std::get<std::string>(GetParam());
                    options.split.clipping = clipping;
                    SCOPED_TRACE(testing::Message()
                                 << "protocol " << static_cast<int>(protocol) << ", "
                                 << name_of(clipping) << ", rate " << rate);
                    check(options);
                }
            }
        }
    }
};

TEST_P(BuildMatrix, TreesAreSound) {
    const Primitives scene(std::get<NamedScene>(GetParam()).make());
    const PrimitiveSetView primitives = primitives_of(scene);
    for_all_options([&](const KdOptions& options) {
        const auto [tree, report] = build_kd_tree(primitives, options);
        EXPECT_TRUE(is_sound(tree, primitives));
        EXPECT_TRUE(is_in_order(tree));
        EXPECT_LE(depth_of(tree), options.split.max_depth);
        EXPECT_EQ(distinct_reference_count(tree), primitives.size());
        if (std::get<PrimitiveKind>(GetParam()) == PrimitiveKind::points) {
            EXPECT_EQ(tree.references().size(), primitives.size()) << "points in several leaves";
        }
        EXPECT_EQ(report.primitive_count, primitives.size());
        EXPECT_EQ(report.sample_count, sample_count(primitives.size(), options.sample.rate));
        EXPECT_EQ(report.statistics.reference_count, tree.references().size());
    });
}

// The test that ties build and refill together.
TEST_P(BuildMatrix, RefillOfAllGivesBackTheDirectBuild) {
    const Primitives scene(std::get<NamedScene>(GetParam()).make());
    const PrimitiveSetView primitives = primitives_of(scene);
    for (const Clipping clipping : {Clipping::perfect, Clipping::bounding_box}) {
        for (const std::uint32_t max_leaf : {1U, 4U, 32U}) {
            const KdOptions options{.split = {.rule = std::get<std::string>(GetParam()),
                                              .max_leaf = max_leaf,
                                              .clipping = clipping},
                                    .leaf_refinement = LeafRefinement::none};
            const Sample all = draw_sample(primitives, options.sample);
            const KdTree direct = build_on_sample(primitives, all, options);
            const KdTree refilled = refill(empty_leaves(KdTree(direct)), primitives, options);
            EXPECT_TRUE(refilled == direct) << name_of(clipping) << ", max leaf " << max_leaf;
            EXPECT_TRUE(build_kd_tree(primitives, options).tree == direct);
        }
    }
}

TEST_P(BuildMatrix, ThreadsDoNotMatter) {
    const Primitives scene(std::get<NamedScene>(GetParam()).make());
    const PrimitiveSetView primitives = primitives_of(scene);
    for (const double rate : {1.0, 0.1}) {
        KdOptions options = options_of(Protocol::grown, rate);
        options.split.rule = std::get<std::string>(GetParam());
        options.threads = 1;
        const KdTree expected = build_kd_tree(primitives, options).tree;
        for (const int threads : {2, 3, 8}) {
            options.threads = threads;
            EXPECT_TRUE(build_kd_tree(primitives, options).tree == expected)
                << threads << " threads";
        }
    }
}

std::string matrix_name(const testing::TestParamInfo<MatrixCase>& info) {
    const auto& [scene, rule, kind] = info.param;
    return std::string(scene.name) + "_" + rule +
           (kind == PrimitiveKind::points ? "_points" : "_triangles");
}

INSTANTIATE_TEST_SUITE_P(Seed3, BuildMatrix,
                         testing::Combine(testing::ValuesIn(scene_matrix()),
                                          testing::Values("sah", "median", "midpoint"),
                                          testing::Values(PrimitiveKind::triangles,
                                                          PrimitiveKind::points)),
                         matrix_name);

// Scenes large enough for several tasks.
class BuildInParallel : public testing::TestWithParam<NamedScene> {};

TEST_P(BuildInParallel, GivesTheSameTreeEveryTime) {
    const Primitives scene(GetParam().make());
    for (const PrimitiveKind kind : {PrimitiveKind::triangles, PrimitiveKind::points}) {
        const PrimitiveSetView primitives = scene.of(kind);
        for (const double rate : {1.0, 0.1}) {
            for (const LeafRefinement leaf_refinement :
                 {LeafRefinement::none, LeafRefinement::kd}) {
                KdOptions options{
                    .sample = {.rate = rate}, .leaf_refinement = leaf_refinement, .threads = 1};
                const KdTree expected = build_kd_tree(primitives, options).tree;
                EXPECT_TRUE(is_sound(expected, primitives));
                for (const int threads : {2, 3, 8, 0}) {
                    options.threads = threads;
                    EXPECT_TRUE(build_kd_tree(primitives, options).tree == expected);
                }
            }
        }
    }
}

INSTANTIATE_TEST_SUITE_P(Seed1, BuildInParallel,
                         testing::Values(NamedScene{"terrain", [] { return make_terrain(50, 1); }},
                                         NamedScene{"soup",
                                                    [] { return make_soup(4500, 0.03F, 1); }}),
                         scene_name);

TEST(BuildKdTree, DependsOnTheSeed) {
    const TriangleMesh mesh = make_soup(2000, 0.1F, 1);
    const auto build = [&](double rate, std::uint64_t seed) {
        return build_kd_tree(mesh.view(), {.sample = {.rate = rate, .seed = seed}}).tree;
    };
    EXPECT_TRUE(build(0.1, 5) == build(0.1, 5));
    EXPECT_FALSE(build(0.1, 5) == build(0.1, 6));
    EXPECT_TRUE(build(1.0, 5) == build(1.0, 6)) << "nothing is drawn at rate 1";
}

TEST(BuildKdTree, TakesASampleOfOne) {
    for (const LeafRefinement leaf_refinement : {LeafRefinement::none, LeafRefinement::kd}) {
        for (const char* const rule : {"sah", "median", "midpoint"}) {
            const TriangleMesh mesh = make_soup(1000, 0.1F, 2);
            const auto [tree, report] =
                build_kd_tree(mesh.view(), {.sample = {.rate = 1e-9},
                                            .split = {.rule = rule, .max_leaf = 1},
                                            .leaf_refinement = leaf_refinement});
            EXPECT_EQ(report.sample_count, 1U);
            EXPECT_TRUE(is_sound(tree, mesh.view()));
            EXPECT_EQ(tree.nodes().size() > 1, leaf_refinement == LeafRefinement::kd);
        }
    }
}

TEST(BuildKdTree, OfNothingIsTheTreeOfNothing) {
    for (const double rate : {1.0, 0.01}) {
        for (const LeafRefinement leaf_refinement : {LeafRefinement::none, LeafRefinement::kd}) {
            const auto [tree, report] = build_kd_tree(
                TriangleMeshView(), {.sample = {.rate = rate}, .leaf_refinement = leaf_refinement});
            EXPECT_TRUE(tree == KdTree{});
            EXPECT_EQ(report.sample_count, 0U);
            EXPECT_EQ(report.statistics.node_count, 1U);
        }
    }
}

TEST(BuildKdTree, BoxIsThatOfAllPrimitives) {
    const TriangleMesh mesh = make_soup(1000, 0.1F, 2);
    for (const double rate : {1.0, 0.001}) {
        EXPECT_EQ(build_kd_tree(mesh.view(), {.sample = {.rate = rate}}).tree.bounds(),
                  bounds_of(mesh.vertices));
    }
}

TEST(BuildKdTree, KeepsToTheDepthLimit) {
    const TriangleMesh mesh = make_soup(2000, 0.1F, 3);
    for (const double rate : {1.0, 0.1}) {
        for (const LeafRefinement leaf_refinement : {LeafRefinement::none, LeafRefinement::kd}) {
            for (const int max_depth : {0, 1, 2, 5, 60}) {
                const KdTree tree =
                    build_kd_tree(mesh.view(), {.sample = {.rate = rate},
                                                .split = {.max_depth = max_depth, .max_leaf = 1},
                                                .leaf_refinement = leaf_refinement})
                        .tree;
                EXPECT_LE(depth_of(tree), max_depth);
                EXPECT_TRUE(max_depth > 5 || depth_of(tree) == max_depth);
                EXPECT_TRUE(is_sound(tree, mesh.view()));
            }
        }
    }
}

TEST(BuildKdTree, ReportsWhatItDid) {
    const TriangleMesh mesh = make_soup(1000, 0.1F, 4);
    const KdOptions options{.sample = {.rate = 0.1, .seed = 9}, .cost = {.traversal = 2.0}};
    const auto [tree, report] = build_kd_tree(mesh.view(), options);
    EXPECT_EQ(sample_of(report.options).rate, 0.1);
    EXPECT_EQ(sample_of(report.options).seed, 9U);
    EXPECT_EQ(report.sample.rate, 0.1);
    EXPECT_EQ(cost_of(report.options).traversal, 2.0);
    EXPECT_EQ(report.primitive_count, 1000U);
    EXPECT_EQ(report.sample_count, 100U);
    EXPECT_EQ(report.statistics.node_count, tree.nodes().size());
    EXPECT_GT(report.statistics.sah_cost, 2.0);
    const StageReports& stages = report.stages;
    for (const StageReport& stage :
         {stages.sample, stages.build, stages.empty, stages.refill, stages.refine}) {
        EXPECT_GE(stage.wall_seconds, 0.0);
        EXPECT_GE(stage.cpu_seconds, 0.0);
        EXPECT_GT(stage.items, 0U);
    }
    EXPECT_GT(stages.wall_seconds(), 0.0);
    EXPECT_EQ(stages.sample.items, 100U);
    EXPECT_EQ(stages.build.items, stages.empty.items);
    EXPECT_EQ(stages.refine.items, tree.references().size());
    EXPECT_EQ(report.tree_bytes, tree.byte_count());
    EXPECT_GE(report.peak_bytes, report.tree_bytes + 1000 * sizeof(Aabb));
    EXPECT_LT(report.peak_bytes, 1000 * report.tree_bytes);
    EXPECT_FALSE(report.estimate.has_value());
    EXPECT_TRUE(report.notes.empty());
    const auto [same, unmeasured] = build_kd_tree(mesh.view(), options, {.is_measured = false});
    EXPECT_TRUE(same == tree);
    EXPECT_EQ(unmeasured.statistics.node_count, 0U);
    EXPECT_EQ(unmeasured.tree_bytes, report.tree_bytes);
    EXPECT_EQ(unmeasured.stages.refine.items, stages.refine.items);
}

TEST(BuildKdTree, ChecksItsOptions) {
    const TriangleMesh mesh = make_soup(10, 0.1F, 4);
    for (const KdOptions& options :
         {KdOptions{.sample = {.rate = 0.0}}, KdOptions{.sample = {.sampler = "best"}},
          KdOptions{.split = {.rule = "best"}}, KdOptions{.split = {.max_depth = 61}},
          KdOptions{.cost = {.intersection = 0.0}}, KdOptions{.threads = -1}}) {
        EXPECT_THROW(static_cast<void>(build_kd_tree(mesh.view(), options)), Error);
        EXPECT_THROW(static_cast<void>(build_kd_tree(TriangleMeshView(), options)), Error);
    }
}

}  // namespace
}  // namespace coppice::test
