#include "builders/split/median_split.h"

#include "builders/prim_refs.h"

#include <gtest/gtest.h>

#include <cmath>

namespace coppice::test {
namespace {

std::vector<PrimRef> points_at(const std::vector<Vec3f>& positions) {
    std::vector<PrimRef> prim_refs;
    for (const Vec3f& p : positions) {
        prim_refs.push_back({{p, p}, static_cast<std::uint32_t>(prim_refs.size())});
    }
    return prim_refs;
}

std::optional<SplitCandidate> find(const std::vector<PrimRef>& prim_refs, const Aabb& box) {
    const SahCostModel model;
    return MedianSplit().find({prim_refs, box, model, 0.0});
}

TEST(MedianSplit, HalvesThePrimRefsOnTheLongestAxis) {
    Random random(5);
    for (const std::uint32_t count : {2U, 3U, 100U, 101U}) {
        const auto prim_refs = make_prim_refs(Layout::random, count, random);
        const Aabb box{{0, 0, 0}, {1, 2, 1}};
        const auto split = find(prim_refs, box);
        ASSERT_TRUE(split.has_value());
        EXPECT_EQ(split->plane.axis, Axis::y);
        double below_count = 0;
        for (const PrimRef& prim_ref : prim_refs) {
            const float center = 0.5F * (prim_ref.box.lower.y + prim_ref.box.upper.y);
            below_count += center < split->plane.position ? 1 : 0;
        }
        EXPECT_NEAR(below_count, count / 2.0, 1.0);
    }
}

TEST(MedianSplit, KnowsWhatItCosts) {
    Random random(6);
    const SahCostModel model{.traversal = 2.0, .intersection = 3.0, .empty_bonus = 0.3};
    const auto prim_refs = make_prim_refs(Layout::planar, 50, random);
    const auto split = MedianSplit().find({prim_refs, unit_cube, model, 0.0});
    ASSERT_TRUE(split.has_value());
    EXPECT_NEAR(split->cost, naive_plane_cost(prim_refs, unit_cube, model, split->plane), 1e-9);
}

TEST(MedianSplit, TakesTheNextAxisIfTheMedianIsAtTheEdge) {
    const auto prim_refs =
        points_at({{0, 0, 0.2F}, {0, 0, 0.4F}, {0, 0.5F, 0.6F}, {0, 1, 0.8F}, {3, 1, 1}});
    const auto split = find(prim_refs, {{0, 0, 0}, {3, 1, 1}});
    ASSERT_TRUE(split.has_value());
    EXPECT_EQ(split->plane, (SplitPlane{Axis::y, 0.5F}));
}

TEST(MedianSplit, OffersNothingIfAllMediansAreAtTheEdge) {
    EXPECT_FALSE(find(points_at({{0, 0, 0}, {0, 0, 0}, {1, 1, 1}, {0, 0, 0}}), unit_cube));
}

TEST(MedianSplit, DoesNotOverflow) {
    const auto prim_refs = points_at({{2e38F, 0, 0}, {3e38F, 0, 0}, {3.2e38F, 0, 0}});
    const auto split = find(prim_refs, {{-3e38F, 0, 0}, {3.4e38F, 1, 1}});
    ASSERT_TRUE(split.has_value());
    EXPECT_EQ(split->plane.position, 3e38F);
}

}  // namespace
}  // namespace coppice::test
