#include "coppice/builders/build_on_sample.h"

#include "coppice/builders/draw_sample.h"

#include "builders/descend.h"
#include "builders/split/evaluate_plane.h"
#include "support/meshes.h"
#include "support/scene_matrix.h"
#include "support/tree_checks.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <string>
#include <tuple>
#include <vector>

namespace coppice::test {
namespace {

KdTree build_on(const TriangleMesh& mesh, const KdOptions& options) {
    return build_on_sample(mesh.view(), draw_sample(mesh.view(), options.sample), options);
}

using SceneAndRule = std::tuple<NamedScene, std::string>;

class BuildOnSampleScene : public testing::TestWithParam<SceneAndRule> {};

// The stop rules, seen from the tree: nodes of few primitives are leaves, and no path has more
// splits that do not pay than it may.
TEST_P(BuildOnSampleScene, StopsWhereItShould) {
    const TriangleMesh mesh = std::get<NamedScene>(GetParam()).make();
    const TriangleMeshView view = mesh.view();
    for (const std::uint32_t max_leaf : {1U, 10U}) {
        for (const int bad_refines : {1, 3}) {
            const KdOptions options{.split = {.rule = std::get<std::string>(GetParam()),
                                              .max_depth = 20,
                                              .max_leaf = max_leaf,
                                              .bad_refines = bad_refines}};
            const KdTree tree = build_on(mesh, options);
            std::vector<int> bad_so_far(tree.nodes().size(), 0);
            descend(tree, view, options.split.clipping,
                    [&](const VisitedNode& at, const std::vector<PrimRef>& prim_refs) {
                        const KdNode& node = tree.nodes()[at.index];
                        if (node.is_leaf()) return;
                        EXPECT_GT(prim_refs.size(), max_leaf);
                        EXPECT_LT(at.depth, 20);
                        const double count = static_cast<double>(prim_refs.size());
                        const SplitCandidate split =
                            evaluate_plane({prim_refs, at.box, options.cost, 0.0}, node.plane());
                        const bool is_bad = !(split.cost < options.cost.leaf_cost(count));
                        const int bad = bad_so_far[at.index] + (is_bad ? 1 : 0);
                        EXPECT_LT(bad, bad_refines);
                        bad_so_far[node.lower_child()] = bad_so_far[node.upper_child()] = bad;
                    });
        }
    }
}

std::string scene_and_rule_name(const testing::TestParamInfo<SceneAndRule>& info) {
    const auto& [scene, rule] = info.param;
    return std::string(scene.name) + "_" + rule;
}

INSTANTIATE_TEST_SUITE_P(All, BuildOnSampleScene,
                         testing::Combine(testing::ValuesIn(scene_matrix()),
                                          testing::Values("sah", "median", "midpoint")),
                         scene_and_rule_name);

TEST(BuildOnSample, HoldsTheSampleOnly) {
    const TriangleMesh mesh = make_soup(1000, 0.1F, 1);
    const Sample sample{{3, 14, 159, 265, 358, 979}, {}, {.rate = 0.006}};
    const KdTree tree = build_on_sample(mesh.view(), sample, {.split = {.max_leaf = 1}});
    std::vector<std::uint32_t> ids(tree.references().begin(), tree.references().end());
    std::sort(ids.begin(), ids.end());
    ids.erase(std::unique(ids.begin(), ids.end()), ids.end());
    EXPECT_EQ(ids, sample.ids);
    EXPECT_TRUE(is_in_order(tree));
}

TEST(BuildOnSample, HasTheBoxOfAll) {
    const TriangleMesh mesh = make_soup(1000, 0.1F, 1);
    const KdTree tree = build_on_sample(mesh.view(), {{5}, {}}, {});
    EXPECT_EQ(tree.bounds(), bounds_of(mesh.vertices));
    EXPECT_EQ(tree.references().size(), 1U);
}

TEST(BuildOnSample, OfAnEmptySampleIsALeaf) {
    const TriangleMesh mesh = make_soup(10, 0.1F, 1);
    const KdTree tree = build_on_sample(mesh.view(), {}, {});
    EXPECT_EQ(tree.nodes().size(), 1U);
    EXPECT_EQ(tree.bounds(), bounds_of(mesh.vertices));
}

TEST(BuildOnSample, DoesNotGrow) {
    const TriangleMesh mesh = make_soup(500, 0.1F, 1);
    EXPECT_TRUE(build_on(mesh, {.leaf_refinement = LeafRefinement::kd}) ==
                build_on(mesh, {.leaf_refinement = LeafRefinement::none}));
}

TEST(BuildOnSample, ObeysMaxLeaf) {
    const TriangleMesh mesh = make_soup(500, 0.1F, 1);
    EXPECT_EQ(build_on(mesh, {.split = {.max_leaf = 500}}).nodes().size(), 1U);
    EXPECT_GT(build_on(mesh, {.split = {.max_leaf = 499}}).nodes().size(), 1U);
    std::size_t nodes = 0;
    for (const std::uint32_t max_leaf : {100U, 32U, 8U, 1U}) {
        const KdTree tree = build_on(mesh, {.split = {.max_leaf = max_leaf}});
        EXPECT_GT(tree.nodes().size(), nodes);
        nodes = tree.nodes().size();
    }
}

// Identical triangles that reach across the middle of a larger box: splits at midpoints never pay
// at first, so the number of bad refines decides how far they go.
TEST(BuildOnSample, ObeysBadRefines) {
    TriangleMesh mesh = repeated(
        make_triangle({Vec3f{-1, -1, -1}, Vec3f{1, -0.9F, -0.8F}, Vec3f{0.9F, 1, 1}}), 100);
    const auto depth_with = [&](int bad_refines) {
        return depth_of(build_on(mesh, {.split = {.rule = "midpoint",
                                                  .max_depth = 6,
                                                  .bad_refines = bad_refines,
                                                  .clipping = Clipping::bounding_box},
                                        .cost = {.traversal = 1000.0}}));
    };
    EXPECT_EQ(depth_with(1), 0) << "the first split that does not pay is refused";
    EXPECT_EQ(depth_with(2), 1);
    EXPECT_EQ(depth_with(3), 2);
    EXPECT_EQ(depth_with(100), 6);
}

TEST(BuildOnSample, CountsBadRefinesByPath) {
    // A row of separate clusters, each of which deserves its splits: one path's bad ones must not
    // stop another's.
    TriangleMesh mesh;
    for (int cluster = 0; cluster < 16; ++cluster) {
        const auto x = static_cast<float>(10 * cluster);
        for (int i = 0; i < 20; ++i) {
            const float y = 0.01F * static_cast<float>(i);
            add_triangle(mesh, {Vec3f{x, y, 0}, Vec3f{x + 1, y, 0}, Vec3f{x, y, 1}});
        }
    }
    const KdTree tree = build_on(mesh, {.split = {.max_leaf = 20, .bad_refines = 1}});
    EXPECT_EQ(largest_leaf(tree), 20U);
}

TEST(BuildOnSample, CutsFlatScenesInTheirPlane) {
    const TriangleMesh mesh = make_sheet(16, {0, 0, 5}, {1, 0, 0}, {0, 1, 0});
    const KdTree tree = build_on(mesh, {.split = {.max_leaf = 4}});
    EXPECT_GT(tree.nodes().size(), 100U);
    for (const KdNode& node : tree.nodes()) {
        EXPECT_TRUE(node.is_leaf() || node.axis() != Axis::z);
    }
    EXPECT_LE(largest_leaf(tree), 8U);
}

TEST(BuildOnSample, LeavesScenesWithoutAreaWhole) {
    const TriangleMesh line = make_collinear(100, {1, 0, 0}, 2);
    EXPECT_EQ(build_on(line, {.split = {.max_leaf = 1}}).nodes().size(), 1U);
    const TriangleMesh point = repeated(make_degenerate_points(1, 1), 100);
    EXPECT_EQ(build_on(point, {.split = {.max_leaf = 1}}).nodes().size(), 1U);
}

TEST(BuildOnSample, CountsWhatSampledPrimitivesStandFor) {
    const TriangleMesh mesh = make_soup(2000, 0.05F, 4);
    KdOptions options{.sample = {.rate = 0.1}, .split = {.max_leaf = 200}};
    EXPECT_EQ(build_on(mesh, options).nodes().size(), 1U) << "200 sampled ones";
    options.split.sample_weighting = SampleWeighting::expected;
    EXPECT_GT(build_on(mesh, options).nodes().size(), 1U) << "they stand for 2000";

    Sample sample = draw_sample(mesh.view(), options.sample);
    sample.weights.assign(sample.ids.size(), 0.25F);  // no primitive counts less than one
    EXPECT_EQ(build_on_sample(mesh.view(), sample, options).nodes().size(), 1U);
    sample.weights.assign(sample.ids.size(), 10.0F);
    EXPECT_TRUE(build_on_sample(mesh.view(), sample, options) == build_on(mesh, options));
}

TEST(BuildOnSample, GoesOnUntilNoSplitPaysIfAsked) {
    const TriangleMesh mesh = make_soup(500, 0.05F, 4);
    const KdTree limited = build_on(mesh, {.split = {.max_leaf = 500}});
    const KdTree full =
        build_on(mesh, {.split = {.max_leaf = 500, .termination = Termination::sah}});
    EXPECT_EQ(limited.nodes().size(), 1U);
    EXPECT_GT(full.nodes().size(), 100U);
    EXPECT_TRUE(is_sound(full, mesh.view()));
}

}  // namespace
}  // namespace coppice::test
