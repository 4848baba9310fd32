#include "coppice/builders/build_on_sample.h"
#include "coppice/builders/draw_sample.h"
#include "coppice/builders/empty_leaves.h"
#include "coppice/builders/refill.h"
#include "coppice/builders/refine.h"
#include "coppice/builders/split_finder.h"
#include "coppice/cost/measure.h"

#include "builders/descend.h"
#include "support/meshes.h"
#include "support/scene_matrix.h"
#include "support/sphere_set.h"
#include "support/tree_checks.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <tuple>
#include <vector>

namespace coppice::test {
namespace {

// A tree before and after it was built on.
struct Stages {
    KdTree refilled;
    KdTree grown;
};

Stages grow(PrimitiveSetView primitives, const Sample& sample, const KdOptions& options) {
    KdTree refilled =
        refill(empty_leaves(build_on_sample(primitives, sample, options)), primitives, options);
    KdTree grown = grow_kd(KdTree(refilled), primitives, options);
    return {std::move(refilled), std::move(grown)};
}

Stages grow(PrimitiveSetView primitives, const KdOptions& options) {
    return grow(primitives, draw_sample(primitives, options.sample), options);
}

// Success if every plane of a tree is in another at the same place.
testing::AssertionResult keeps_planes(const KdTree& before, const KdTree& after,
                                      std::uint32_t before_index = 0,
                                      std::uint32_t after_index = 0) {
    const KdNode& old = before.nodes()[before_index];
    if (old.is_leaf()) return testing::AssertionSuccess();
    const KdNode& node = after.nodes()[after_index];
    if (node.is_leaf() || node.plane() != old.plane() || node.planar_side() != old.planar_side()) {
        return testing::AssertionFailure() << "the plane of node " << before_index << " is gone";
    }
    const auto lower = keeps_planes(before, after, old.lower_child(), node.lower_child());
    return lower ? keeps_planes(before, after, old.upper_child(), node.upper_child()) : lower;
}

using SceneAndRule = std::tuple<NamedScene, std::string>;

class GrowKdScene : public testing::TestWithParam<SceneAndRule> {};

TEST_P(GrowKdScene, KeepsAllPlanesAtRateOne) {
    const TriangleMesh mesh = std::get<NamedScene>(GetParam()).make();
    for (const std::uint32_t max_leaf : {4U, 32U}) {
        const KdOptions options{
            .split = {.rule = std::get<std::string>(GetParam()), .max_leaf = max_leaf}};
        const auto [refilled, grown] = grow(mesh.view(), options);
        EXPECT_TRUE(keeps_planes(refilled, grown));
        EXPECT_GE(grown.nodes().size(), refilled.nodes().size());
    }
}

TEST_P(GrowKdScene, GoesOnUntilNoSplitPays) {
    const TriangleMesh mesh = std::get<NamedScene>(GetParam()).make();
    for (const double rate : {1.0, 0.3}) {
        const KdOptions options{
            .sample = {.rate = rate},
            .split = {.rule = std::get<std::string>(GetParam()), .max_depth = 30}};
        const KdTree grown = grow(mesh.view(), options).grown;
        const SplitFinder& finder = find_split_finder(options.split.rule);
        descend(grown, mesh.view(), options.split.clipping,
                [&](const VisitedNode& at, const std::vector<PrimRef>& prim_refs) {
                    const bool is_open = grown.nodes()[at.index].is_leaf() && at.depth < 30 &&
                                         !prim_refs.empty() && at.box.surface_area() > 0.0;
                    if (!is_open) return;
                    const double leaf_cost =
                        options.cost.leaf_cost(static_cast<double>(prim_refs.size()));
                    const auto split = finder.find({prim_refs, at.box, options.cost, leaf_cost});
                    EXPECT_FALSE(split && split->cost < leaf_cost);
                });
    }
}

TEST_P(GrowKdScene, DoesNotMakeTreesWorse) {
    const TriangleMesh mesh = std::get<NamedScene>(GetParam()).make();
    double full_cost = 0.0;
    for (const double rate : {1.0, 0.5, 0.1}) {
        const KdOptions options{.sample = {.rate = rate},
                                .split = {.rule = std::get<std::string>(GetParam())}};
        const auto [refilled, grown] = grow(mesh.view(), options);
        const double refilled_cost = measure(refilled, options.cost).sah_cost;
        const double grown_cost = measure(grown, options.cost).sah_cost;
        // From a sample, what is built anew may be worse than what chance had chosen; one huge
        // triangle among 2000 small ones is the worst case known (1.4 times at rate 0.5).
        const double allowed = rate == 1.0 ? 1.0001 : 1.5;
        EXPECT_LE(grown_cost, allowed * std::max(refilled_cost, full_cost)) << "rate " << rate;
        full_cost = std::max(full_cost, grown_cost);
    }
}

std::string scene_and_rule_name(const testing::TestParamInfo<SceneAndRule>& info) {
    const auto& [scene, rule] = info.param;
    return std::string(scene.name) + "_" + rule;
}

INSTANTIATE_TEST_SUITE_P(Seed1, GrowKdScene,
                         testing::Combine(testing::ValuesIn(scene_matrix()),
                                          testing::Values("sah", "median", "midpoint")),
                         scene_and_rule_name);

// A row of boxes, the sample of which misses what else there is.
std::vector<Aabb> row_of_boxes(std::uint32_t count) {
    std::vector<Aabb> boxes;
    for (std::uint32_t i = 0; i < count; ++i) {
        const float y = static_cast<float>(i) / static_cast<float>(count);
        boxes.push_back({{0, y, 0}, {1, y + 0.5F / static_cast<float>(count), 1}});
    }
    return boxes;
}

Sample first_ids(std::uint32_t count, double rate) {
    Sample sample{{}, {}, {.rate = rate}};
    for (std::uint32_t id = 0; id < count; ++id) {
        sample.ids.push_back(id);
    }
    return sample;
}

TEST(GrowKd, GrowsWhereTheSampleSawNothing) {
    // 400 boxes at x = 0 to 1 are sampled, 40 small ones at x = 8 to 9 are not.
    std::vector<Aabb> boxes = row_of_boxes(400);
    for (int i = 0; i < 40; ++i) {
        const float y = 0.02F * static_cast<float>(i);
        boxes.push_back({{8, y, 0.4F}, {9, y + 0.01F, 0.5F}});
    }
    const BoxSet set(boxes);
    const KdOptions options{.sample = {.rate = 400.0 / 440.0}};
    const auto [refilled, grown] = grow(set, first_ids(400, options.sample.rate), options);
    EXPECT_TRUE(is_sound(grown, set));
    EXPECT_EQ(largest_leaf(refilled), 40U);
    EXPECT_LT(largest_leaf(grown), 40U);
    EXPECT_LT(measure(grown, options.cost).sah_cost, measure(refilled, options.cost).sah_cost);
}

TEST(GrowKd, MovesAPlaneThatCutOffTooMuch) {
    // Sampled: a row at x = 0 to 1 and one box at x = 99. Not sampled: a few that reach to x = 3.
    std::vector<Aabb> boxes = row_of_boxes(400);
    boxes.push_back({{99, 0, 0}, {100, 1, 1}});
    for (int i = 0; i < 5; ++i) {
        boxes.push_back({{2, 0, 0}, {3, 1, 0.1F * static_cast<float>(i)}});
    }
    const BoxSet set(boxes);
    const KdOptions options{.sample = {.rate = 401.0 / 406.0}, .split = {.max_leaf = 1}};
    const auto [refilled, grown] = grow(set, first_ids(401, options.sample.rate), options);
    EXPECT_TRUE(is_sound(grown, set));
    EXPECT_TRUE(is_in_order(grown));
    const auto has_plane_at = [](const KdTree& tree, float position) {
        return std::any_of(tree.nodes().begin(), tree.nodes().end(), [&](const KdNode& node) {
            return !node.is_leaf() && node.plane() == SplitPlane{Axis::x, position};
        });
    };
    EXPECT_TRUE(has_plane_at(refilled, 1.0F));
    EXPECT_TRUE(has_plane_at(grown, 3.0F));
}

TEST(GrowKd, KeepsToTheDepthLimit) {
    const TriangleMesh mesh = make_soup(2000, 0.1F, 1);
    for (const int max_depth : {0, 3, 8}) {
        const KdOptions options{.sample = {.rate = 0.5}, .split = {.max_depth = max_depth}};
        EXPECT_EQ(depth_of(grow(mesh.view(), options).grown), max_depth);
    }
}

TEST(GrowKd, GivesOneTreeForAnySampleTooSmallToTell) {
    // All planes of such samples are retracted, so that nothing of them is left.
    const TriangleMesh mesh = make_soup(1000, 0.1F, 1);
    const auto grown_with = [&](std::uint64_t seed) {
        return grow(mesh.view(), {.sample = {.rate = 0.01, .seed = seed}}).grown;
    };
    EXPECT_TRUE(grown_with(1) == grown_with(2));
}

}  // namespace
}  // namespace coppice::test
