#include "builders/split/evaluate_plane.h"

#include "builders/prim_refs.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace coppice::test {
namespace {

class EvaluatePlane : public testing::TestWithParam<std::uint64_t> {};

TEST_P(EvaluatePlane, AgreesWithTheNaiveCost) {
    Random random(GetParam());
    for (const Layout layout : {Layout::random, Layout::grid, Layout::planar, Layout::points}) {
        for (int round = 0; round < 200; ++round) {
            const auto prim_refs = make_prim_refs(layout, 1 + random.below(20), random);
            const SahCostModel model{.traversal = 2.0, .intersection = 3.0, .empty_bonus = 0.4};
            const auto axis = static_cast<Axis>(random.below(3));
            const SplitPlane plane{axis, 0.125F * static_cast<float>(1 + random.below(7))};
            const SplitCandidate split = evaluate_plane({prim_refs, unit_cube, model, 0.0}, plane);
            EXPECT_EQ(split.plane, plane);
            const double expected = naive_plane_cost(prim_refs, unit_cube, model, plane);
            EXPECT_NEAR(split.cost, expected, 1e-12 * expected);
            EXPECT_NEAR(naive_split_cost(prim_refs, unit_cube, model, plane, split.planar_side),
                        expected, 1e-12 * expected);
        }
    }
}

INSTANTIATE_TEST_SUITE_P(Seed, EvaluatePlane, testing::Values(1U, 2U),
                         [](const auto& each) { return std::to_string(each.param); });

TEST(PlaneEvaluator, OffersOnlyTheInside) {
    const SahCostModel model;
    const Aabb box{{1, 2, 3}, {2, 4, 6}};
    for (const Axis axis : all_axes) {
        const PlaneEvaluator evaluator(box, axis, model);
        EXPECT_FALSE(evaluator.is_inside(box.lower[axis]));
        EXPECT_FALSE(evaluator.is_inside(box.upper[axis]));
        EXPECT_TRUE(evaluator.is_inside(std::nextafter(box.lower[axis], 9.0F)));
        EXPECT_TRUE(evaluator.is_inside(std::nextafter(box.upper[axis], 0.0F)));
        EXPECT_FALSE(evaluator.is_inside(std::numeric_limits<float>::quiet_NaN()));
        EXPECT_FALSE(evaluator.is_inside(std::numeric_limits<float>::infinity()));
    }
}

TEST(PlaneEvaluator, PutsPlanarPrimRefsBelowIfItIsTheSame) {
    const SahCostModel model{.empty_bonus = 0.0};
    const PlaneEvaluator evaluator(unit_cube, Axis::x, model);
    EXPECT_EQ(evaluator.evaluate(0.5F, {3, 3, 2}).planar_side, PlanarSide::below);
    EXPECT_EQ(evaluator.evaluate(0.25F, {3, 3, 2}).planar_side, PlanarSide::below);
    EXPECT_EQ(evaluator.evaluate(0.75F, {3, 3, 2}).planar_side, PlanarSide::above);
    EXPECT_EQ(evaluator.evaluate(0.75F, {3, 3, 0}).planar_side, PlanarSide::below);
}

TEST(PlaneEvaluator, GivesTheBonusForOneSideOfPlanars) {
    const SahCostModel model{.traversal = 1.0, .intersection = 1.0, .empty_bonus = 0.5};
    const PlaneEvaluator evaluator(unit_cube, Axis::x, model);
    // All eight in the plane: the other side is empty. Halves have 4 of 6 faces.
    EXPECT_DOUBLE_EQ(evaluator.evaluate(0.5F, {0, 0, 8}).cost, 1.0 + 0.5 * 8.0 * 4.0 / 6.0);
}

}  // namespace
}  // namespace coppice::test
