#include "builders/split/midpoint_split.h"

#include "builders/prim_refs.h"

#include <gtest/gtest.h>

#include <cmath>

namespace coppice::test {
namespace {

std::optional<SplitCandidate> find(const Aabb& box) {
    const std::vector<PrimRef> prim_refs{{box, 0}};
    const SahCostModel model;
    return MidpointSplit().find({prim_refs, box, model, 0.0});
}

TEST(MidpointSplit, HalvesTheLongestAxis) {
    EXPECT_EQ(find({{0, 0, 0}, {1, 1, 4}})->plane, (SplitPlane{Axis::z, 2.0F}));
    EXPECT_EQ(find({{-3, 0, 0}, {1, 1, 1}})->plane, (SplitPlane{Axis::x, -1.0F}));
    EXPECT_EQ(find({{0, 5, 0}, {0, 7, 1}})->plane, (SplitPlane{Axis::y, 6.0F}));
}

TEST(MidpointSplit, KnowsWhatItCosts) {
    Random random(6);
    const SahCostModel model{.traversal = 2.0, .intersection = 3.0, .empty_bonus = 0.3};
    const auto prim_refs = make_prim_refs(Layout::grid, 50, random);
    const auto split = MidpointSplit().find({prim_refs, unit_cube, model, 0.0});
    ASSERT_TRUE(split.has_value());
    EXPECT_NEAR(split->cost, naive_plane_cost(prim_refs, unit_cube, model, split->plane), 1e-9);
}

TEST(MidpointSplit, DoesNotOverflow) {
    EXPECT_EQ(find({{-3e38F, 0, 0}, {3.2e38F, 1, 1}})->plane.axis, Axis::x);
    EXPECT_FLOAT_EQ(find({{3e38F, 0, 0}, {3.4e38F, 1, 1}})->plane.position, 3.2e38F);
}

TEST(MidpointSplit, OffersNothingBetweenNeighboringFloats) {
    const float next = std::nextafter(1.0F, 2.0F);
    EXPECT_FALSE(find({{1, 1, 1}, {next, 1, 1}}).has_value());
    EXPECT_FALSE(find({{0, 0, 0}, {1e-45F, 0, 0}}).has_value());
}

}  // namespace
}  // namespace coppice::test
