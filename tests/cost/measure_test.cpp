#include "coppice/cost/measure.h"

#include "coppice/builders/build_tree.h"
#include "coppice/tree/walk.h"

#include "support/meshes.h"
#include "support/rays.h"
#include "support/scene_matrix.h"
#include "support/tree_checks.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <numeric>
#include <string>

namespace coppice::test {
namespace {

using testing::DoubleEq;
using testing::ElementsAre;

const SahCostModel model{.traversal = 3.0, .intersection = 2.0};

TEST(Measure, OfNothingCostsNothing) {
    const TreeStatistics measured = measure(KdTree{}, model);
    EXPECT_EQ(measured.node_count, 1U);
    EXPECT_EQ(measured.inner_count, 0U);
    EXPECT_EQ(measured.leaf_count, 1U);
    EXPECT_EQ(measured.empty_leaf_count, 1U);
    EXPECT_EQ(measured.max_level, 0);
    EXPECT_EQ(measured.mean_leaf_size, 0.0);
    EXPECT_EQ(measured.sah_cost, 0.0);
    EXPECT_THAT(measured.depth_histogram, ElementsAre(1));
    EXPECT_THAT(measured.cost_share_by_depth, ElementsAre(0.0));
}

TEST(Measure, OfALeafIsTheCostOfItsPrimitives) {
    const KdTree tree({KdNode::make_leaf(0, 3)}, {0, 1, 2}, {{0, 0, 0}, {1, 1, 1}});
    const TreeStatistics measured = measure(tree, model);
    EXPECT_EQ(measured.sah_cost, 6.0);
    EXPECT_EQ(measured.expected_inner_visits, 0.0);
    EXPECT_EQ(measured.expected_leaf_visits, 1.0);
    EXPECT_EQ(measured.expected_primitive_tests, 3.0);
    EXPECT_EQ(measured.mean_leaf_size, 3.0);
    EXPECT_THAT(measured.cost_share_by_depth, ElementsAre(1.0));
}

// A box of 4 x 1 x 1 (area 18), cut at x = 1: below 1 x 1 x 1 (area 6) with one primitive, above
// 3 x 1 x 1 (area 14); that cut at y = 0.25: 3 x .25 x 1 (area 8) empty, 3 x .75 x 1 (area 12)
// with two.
TEST(Measure, AgreesWithAHandCount) {
    const KdTree tree(
        {KdNode::make_inner({Axis::x, 1.0F}, PlanarSide::below, 1), KdNode::make_leaf(0, 1),
         KdNode::make_inner({Axis::y, 0.25F}, PlanarSide::above, 3), KdNode::make_leaf(1, 0),
         KdNode::make_leaf(1, 2)},
        {0, 1, 2}, {{0, 0, 0}, {4, 1, 1}});
    const TreeStatistics measured = measure(tree, model);
    EXPECT_EQ(measured.node_count, 5U);
    EXPECT_EQ(measured.inner_count, 2U);
    EXPECT_EQ(measured.leaf_count, 3U);
    EXPECT_EQ(measured.single_primitive_leaf_count, 1U);
    EXPECT_EQ(measured.empty_leaf_count, 1U);
    EXPECT_EQ(measured.reference_count, 3U);
    EXPECT_EQ(measured.max_level, 2);
    EXPECT_EQ(measured.mean_leaf_size, 1.0);
    EXPECT_THAT(measured.depth_histogram, ElementsAre(0, 1, 2));
    // Upper child: 3 + 12/14 * 2 * 2 = 45/7. Root: 3 + 6/18 * 2 * 1 + 14/18 * 45/7.
    EXPECT_DOUBLE_EQ(measured.sah_cost, 3.0 + 2.0 / 3.0 + 5.0);
    EXPECT_DOUBLE_EQ(measured.expected_inner_visits, 1.0 + 14.0 / 18.0);
    EXPECT_DOUBLE_EQ(measured.expected_leaf_visits, 6.0 / 18.0 + 8.0 / 18.0 + 12.0 / 18.0);
    EXPECT_DOUBLE_EQ(measured.expected_primitive_tests, 6.0 / 18.0 + 2.0 * 12.0 / 18.0);
    // Levels: 3; 2/3 + 14/18 * 3 = 3; 12/18 * 4 = 8/3. In all 26/3.
    EXPECT_THAT(measured.cost_share_by_depth,
                ElementsAre(DoubleEq(9.0 / 26.0), DoubleEq(9.0 / 26.0), DoubleEq(8.0 / 26.0)));
}

TEST(Measure, CountsAFlatBoxByItsTwoFaces) {
    // 4 x 1 x 0: area 8, cut in halves of area 4.
    const KdTree tree({KdNode::make_inner({Axis::x, 2.0F}, PlanarSide::below, 1),
                       KdNode::make_leaf(0, 1), KdNode::make_leaf(1, 1)},
                      {0, 1}, {{0, 0, 5}, {4, 1, 5}});
    const TreeStatistics measured = measure(tree, model);
    EXPECT_DOUBLE_EQ(measured.expected_leaf_visits, 1.0);
    EXPECT_DOUBLE_EQ(measured.sah_cost, 3.0 + 2.0);
}

TEST(Measure, CountsNothingBelowANodeWithoutArea) {
    const KdTree tree({KdNode::make_inner({Axis::x, 2.0F}, PlanarSide::below, 1),
                       KdNode::make_leaf(0, 1), KdNode::make_leaf(1, 1)},
                      {0, 1}, {{0, 7, 5}, {4, 7, 5}});
    const TreeStatistics measured = measure(tree, model);
    EXPECT_EQ(measured.sah_cost, 3.0);
    EXPECT_EQ(measured.expected_leaf_visits, 0.0);
    EXPECT_EQ(measured.leaf_count, 2U);
}

TEST(Measure, WorksAtAllScales) {
    for (const float scale : {1e-45F, 1e-30F, 1.0F, 1e30F, 3e38F}) {
        const KdTree tree({KdNode::make_leaf(0, 2)}, {0, 1}, {{0, 0, 0}, {scale, scale, scale}});
        EXPECT_EQ(measure(tree, model).sah_cost, 4.0);
    }
    const TriangleMesh mesh = make_soup(300, 0.1F, 2);
    const double expected = measure(build_kd_tree(mesh.view()).tree, model).sah_cost;
    for (const float scale : {0x1p-100F, 0x1p-40F, 0x1p40F, 0x1p100F}) {
        const TriangleMesh other = scaled(mesh, scale);
        EXPECT_NEAR(measure(build_kd_tree(other.view()).tree, model).sah_cost, expected,
                    1e-9 * expected);
    }
}

// The same sums, written node by node from the boxes that a walk gives.
struct BruteSums {
    double inner_visits = 0.0;
    double leaf_visits = 0.0;
    double tests = 0.0;
    std::vector<double> costs;
};

BruteSums brute_sums(const KdTree& tree) {
    BruteSums sums;
    const double root_area = tree.bounds().surface_area();
    walk(tree, [&](const VisitedNode& at) {
        const KdNode& node = tree.nodes()[at.index];
        const double area = at.box.surface_area();
        const double probability = at.index == 0 ? 1.0 : root_area > 0.0 ? area / root_area : 0.0;
        sums.costs.resize(std::max(sums.costs.size(), static_cast<std::size_t>(at.depth) + 1));
        double& cost = sums.costs[static_cast<std::size_t>(at.depth)];
        if (node.is_leaf()) {
            sums.leaf_visits += probability;
            sums.tests += probability * node.reference_count();
            cost += probability * model.intersection * node.reference_count();
        } else {
            sums.inner_visits += probability;
            cost += probability * model.traversal;
        }
    });
    return sums;
}

class MeasureScene : public testing::TestWithParam<NamedScene> {};

TEST_P(MeasureScene, AgreesWithABruteSum) {
    const TriangleMesh mesh = GetParam().make();
    for (const double rate : {1.0, 0.1}) {
        for (const LeafRefinement leaf_refinement : {LeafRefinement::none, LeafRefinement::kd}) {
            const KdTree tree = build_kd_tree(mesh.view(), {.sample = {.rate = rate},
                                                            .split = {.max_leaf = 4},
                                                            .leaf_refinement = leaf_refinement})
                                    .tree;
            const TreeStatistics measured = measure(tree, model);
            const BruteSums sums = brute_sums(tree);
            const double total = std::accumulate(sums.costs.begin(), sums.costs.end(), 0.0);
            EXPECT_NEAR(measured.sah_cost, total, 1e-9 * total);
            EXPECT_NEAR(measured.expected_inner_visits, sums.inner_visits, 1e-9 * total);
            EXPECT_NEAR(measured.expected_leaf_visits, sums.leaf_visits, 1e-9 * total);
            EXPECT_NEAR(measured.expected_primitive_tests, sums.tests, 1e-9 * total);
            EXPECT_NEAR(measured.sah_cost,
                        model.traversal * measured.expected_inner_visits +
                            model.intersection * measured.expected_primitive_tests,
                        1e-9 * total);
            ASSERT_EQ(measured.cost_share_by_depth.size(), sums.costs.size());
            for (std::size_t level = 0; level < sums.costs.size(); ++level) {
                const double share = total > 0.0 ? sums.costs[level] / total : 0.0;
                EXPECT_NEAR(measured.cost_share_by_depth[level], share, 1e-9);
            }
        }
    }
}

TEST_P(MeasureScene, CountsAddUp) {
    const TriangleMesh mesh = GetParam().make();
    const KdTree tree = build_kd_tree(mesh.view(), {.sample = {.rate = 0.5}}).tree;
    const TreeStatistics measured = measure(tree, model);
    EXPECT_EQ(measured.node_count, tree.nodes().size());
    EXPECT_EQ(measured.inner_count + measured.leaf_count, measured.node_count);
    EXPECT_EQ(measured.leaf_count, measured.inner_count + 1);
    EXPECT_EQ(measured.reference_count, tree.references().size());
    EXPECT_EQ(measured.max_level, depth_of(tree));
    const auto count_leaves = [&](std::uint32_t size) {
        return std::count_if(tree.nodes().begin(), tree.nodes().end(), [&](const KdNode& node) {
            return node.is_leaf() && node.reference_count() == size;
        });
    };
    EXPECT_EQ(measured.empty_leaf_count, count_leaves(0));
    EXPECT_EQ(measured.single_primitive_leaf_count, count_leaves(1));
    ASSERT_EQ(measured.depth_histogram.size(), measured.max_level + 1U);
    EXPECT_EQ(std::accumulate(measured.depth_histogram.begin(), measured.depth_histogram.end(),
                              std::uint64_t{0}),
              measured.leaf_count);
    EXPECT_GT(measured.depth_histogram.back(), 0U);
    const double shares = std::accumulate(measured.cost_share_by_depth.begin(),
                                          measured.cost_share_by_depth.end(), 0.0);
    EXPECT_NEAR(shares, measured.sah_cost > 0.0 ? 1.0 : 0.0, 1e-12);
}

INSTANTIATE_TEST_SUITE_P(Scene, MeasureScene, testing::ValuesIn(scene_matrix()), scene_name);

// Whether a line (from its entry on) meets a closed box.
bool meets(const Ray& line, const Aabb& box) {
    double enter = -Aabb::infinity;
    double exit = Aabb::infinity;
    for (const Axis axis : all_axes) {
        const double direction = line.direction[axis];
        const double first = (box.lower[axis] - static_cast<double>(line.origin[axis])) / direction;
        const double second =
            (box.upper[axis] - static_cast<double>(line.origin[axis])) / direction;
        enter = std::max(enter, std::min(first, second));
        exit = std::min(exit, std::max(first, second));
    }
    return enter <= exit;
}

// Mean and squares of a quantity over random lines.
struct Average {
    double sum = 0.0;
    double squares = 0.0;
    int count = 0;

    void add(double value) {
        sum += value;
        squares += value * value;
        ++count;
    }

    // How many standard errors the mean is off an expectation.
    [[nodiscard]] double deviation_from(double expected) const {
        const double mean = sum / count;
        const double variance = std::max(squares / count - mean * mean, 1e-20);
        return (mean - expected) / std::sqrt(variance / count);
    }
};

// Counts what a random line meets, box by box, over a whole tree.
struct LineCounts {
    double inner = 0.0;
    double leaves = 0.0;
    double tests = 0.0;
};

LineCounts count_along(const Ray& line, const KdTree& tree) {
    LineCounts counts;
    const std::function<void(const VisitedNode&)> visit = [&](const VisitedNode& at) {
        if (at.index != 0 && !meets(line, at.box)) return;
        const KdNode& node = tree.nodes()[at.index];
        if (node.is_leaf()) {
            counts.leaves += 1.0;
            counts.tests += node.reference_count();
            return;
        }
        counts.inner += 1.0;
        visit({node.lower_child(), below(at.box, node.plane()), at.depth + 1});
        visit({node.upper_child(), above(at.box, node.plane()), at.depth + 1});
    };
    visit({0, tree.bounds(), 0});
    return counts;
}

class MeasureByRandomLines : public testing::TestWithParam<NamedScene> {};

TEST_P(MeasureByRandomLines, ExpectsWhatTheyMeet) {
    const TriangleMesh mesh = GetParam().make();
    const KdTree tree = build_kd_tree(mesh.view(), {.sample = {.rate = 0.5}}).tree;
    const TreeStatistics measured = measure(tree, model);
    Random random(2024);
    Average inner;
    Average leaves;
    Average tests;
    for (int i = 0; i < 40'000; ++i) {
        const LineCounts counts = count_along(random_line_through(tree.bounds(), random), tree);
        inner.add(counts.inner);
        leaves.add(counts.leaves);
        tests.add(counts.tests);
    }
    EXPECT_LT(std::abs(inner.deviation_from(measured.expected_inner_visits)), 4.0);
    EXPECT_LT(std::abs(leaves.deviation_from(measured.expected_leaf_visits)), 4.0);
    EXPECT_LT(std::abs(tests.deviation_from(measured.expected_primitive_tests)), 4.0);
}

INSTANTIATE_TEST_SUITE_P(
    Seed2024, MeasureByRandomLines,
    testing::Values(NamedScene{"soup", [] { return make_soup(200, 0.1F, 1); }},
                    NamedScene{"sphere", [] { return make_sphere(8, 12); }},
                    NamedScene{"flat_terrain", [] { return make_terrain(12, 1); }},
                    NamedScene{"sheet",
                               [] {
                                   return make_sheet(8, {0, 0, 5}, {0.1F, 0, 0}, {0, 0.3F, 0});
                               }}),
    scene_name);

}  // namespace
}  // namespace coppice::test
