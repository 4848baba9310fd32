#include "builders/split/sah_sweep.h"

#include "builders/prim_refs.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <optional>
#include <tuple>

namespace coppice::test {
namespace {

constexpr double no_limit = std::numeric_limits<double>::infinity();

// The least cost of all planes on an axis, by trying every PrimRef end; infinite if there is none.
double naive_best_cost(const std::vector<PrimRef>& prim_refs, const Aabb& box, Axis axis,
                       const SahCostModel& model) {
    double best = no_limit;
    for (const PrimRef& prim_ref : prim_refs) {
        for (const float position : {prim_ref.box.lower[axis], prim_ref.box.upper[axis]}) {
            if (!(position > box.lower[axis] && position < box.upper[axis])) continue;
            best = std::min(best, naive_plane_cost(prim_refs, box, model, {axis, position}));
        }
    }
    return best;
}

// What the sweep should find: axis by axis from the longest on, until one is acceptable.
double naive_cost(const std::vector<PrimRef>& prim_refs, const Aabb& box, const SahCostModel& model,
                  double acceptable) {
    double best = no_limit;
    Axis axis = box.longest_axis();
    for (int tried = 0; tried < 3; ++tried, axis = next_axis(axis)) {
        best = std::min(best, naive_best_cost(prim_refs, box, axis, model));
        if (best < acceptable) break;
    }
    return best;
}

using LayoutAndSeed = std::tuple<Layout, std::uint64_t>;

class SahSweepOracle : public testing::TestWithParam<LayoutAndSeed> {};

TEST_P(SahSweepOracle, FindsTheCheapestPlane) {
    const auto [layout, seed] = GetParam();
    Random random(seed);
    for (int round = 0; round < 300; ++round) {
        const auto prim_refs = make_prim_refs(layout, 1 + random.below(30), random);
        const SahCostModel model{.traversal = 2.0 * random.unit(),
                                 .intersection = 0.5 + random.unit(),
                                 .empty_bonus = round % 2 == 0 ? 0.0 : 0.9 * random.unit()};
        Aabb box = unit_cube;
        box.upper[static_cast<Axis>(random.below(3))] = 1.5F;
        const double leaf_cost = model.leaf_cost(static_cast<double>(prim_refs.size()));
        for (const double acceptable : {no_limit, leaf_cost, 0.0}) {
            const auto split = SahSweep().find({prim_refs, box, model, acceptable});
            const double expected = naive_cost(prim_refs, box, model, acceptable);
            ASSERT_EQ(split.has_value(), expected < no_limit);
            if (!split) continue;
            EXPECT_NEAR(split->cost, expected, 1e-12 * expected);
            // The plane and the side it names are worth that cost.
            EXPECT_GT(split->plane.position, box.lower[split->plane.axis]);
            EXPECT_LT(split->plane.position, box.upper[split->plane.axis]);
            EXPECT_NEAR(naive_split_cost(prim_refs, box, model, split->plane, split->planar_side),
                        expected, 1e-12 * expected);
        }
    }
}

std::string layout_name(const testing::TestParamInfo<LayoutAndSeed>& info) {
    constexpr std::array names{"random", "grid", "planar", "points", "identical"};
    const auto [layout, seed] = info.param;
    return names.at(static_cast<std::size_t>(layout)) + ("_" + std::to_string(seed));
}

INSTANTIATE_TEST_SUITE_P(All, SahSweepOracle,
                         testing::Combine(testing::Values(Layout::random, Layout::grid,
                                                          Layout::planar, Layout::points,
                                                          Layout::identical),
                                          testing::Values(1U, 2U, 3U)),
                         layout_name);

std::optional<SplitCandidate> find_by_sah(const std::vector<PrimRef>& prim_refs, const Aabb& box,
                                          const SahCostModel& model = {},
                                          double acceptable = no_limit) {
    return SahSweep().find({prim_refs, box, model, acceptable});
}

TEST(SahSweep, SeparatesTwoClusters) {
    std::vector<PrimRef> prim_refs;
    for (std::uint32_t id = 0; id < 10; ++id) {
        const float x = id < 5 ? 0.0F : 7.0F;
        prim_refs.push_back({{{x, 0, 0}, {x + 1, 1, 1}}, id});
    }
    const auto split = find_by_sah(prim_refs, {{0, 0, 0}, {8, 1, 1}}, {.empty_bonus = 0.0});
    ASSERT_TRUE(split.has_value());
    EXPECT_EQ(split->plane, (SplitPlane{Axis::x, 1.0F}));
    // Area 34; 1 x 1 x 1 below has 6, 7 x 1 x 1 above has 30.
    EXPECT_DOUBLE_EQ(split->cost, 1.0 + 5.0 * 6.0 / 34.0 + 5.0 * 30.0 / 34.0);
}

TEST(SahSweep, PrefersToCutOffEmptySpace) {
    const std::vector<PrimRef> prim_refs(10, PrimRef{{{7, 0, 0}, {8, 1, 1}}, 0});
    const auto split = find_by_sah(prim_refs, {{0, 0, 0}, {8, 1, 1}}, {.empty_bonus = 0.5});
    ASSERT_TRUE(split.has_value());
    EXPECT_EQ(split->plane, (SplitPlane{Axis::x, 7.0F}));
    EXPECT_DOUBLE_EQ(split->cost, 1.0 + 0.5 * 10.0 * 6.0 / 34.0);
}

TEST(SahSweep, HasNothingToOfferWhereAllFillTheNode) {
    EXPECT_FALSE(find_by_sah({5, PrimRef{unit_cube, 0}}, unit_cube).has_value());
    EXPECT_FALSE(find_by_sah({5, PrimRef{unit_cube, 0}}, unit_cube, {}, 0.0).has_value());
}

TEST(SahSweep, TriesOtherAxesOnlyIfTheLongestOffersNothing) {
    const Aabb box{{0, 0, 0}, {8, 2, 2}};
    // A perfect cut on y, a bad one on x.
    std::vector<PrimRef> prim_refs;
    for (std::uint32_t id = 0; id < 20; ++id) {
        const float y = id < 10 ? 0.0F : 1.0F;
        prim_refs.push_back({{{0, y, 0}, {8, y + 1, 2}}, id});
    }
    const auto on_y = find_by_sah(prim_refs, box);
    ASSERT_TRUE(on_y.has_value());
    EXPECT_EQ(on_y->plane, (SplitPlane{Axis::y, 1.0F}));
    prim_refs.push_back({{{0, 0, 0}, {7.5F, 1, 2}}, 20});
    const auto on_x = find_by_sah(prim_refs, box);
    ASSERT_TRUE(on_x.has_value());
    EXPECT_EQ(on_x->plane, (SplitPlane{Axis::x, 7.5F}));
    const auto on_any = find_by_sah(prim_refs, box, {}, 20.0);
    ASSERT_TRUE(on_any.has_value());
    EXPECT_EQ(on_any->plane, (SplitPlane{Axis::y, 1.0F}));
}

TEST(SahSweep, PutsPlanarPrimRefsOnTheCheaperSide) {
    const Aabb box{{0, 0, 0}, {4, 1, 1}};
    std::vector<PrimRef> prim_refs(4, PrimRef{{{1, 0, 0}, {1, 1, 1}}, 0});
    const auto low = find_by_sah(prim_refs, box, {.empty_bonus = 0.0});
    ASSERT_TRUE(low.has_value());
    EXPECT_EQ(low->planar_side, PlanarSide::below);
    prim_refs.assign(4, PrimRef{{{3, 0, 0}, {3, 1, 1}}, 0});
    const auto high = find_by_sah(prim_refs, box, {.empty_bonus = 0.0});
    ASSERT_TRUE(high.has_value());
    EXPECT_EQ(high->planar_side, PlanarSide::above);
}

TEST(SahSweep, DoesNotMindTheOrderOfPrimRefs) {
    Random random(9);
    auto prim_refs = make_prim_refs(Layout::planar, 2000, random);
    const auto expected = find_by_sah(prim_refs, unit_cube);
    std::reverse(prim_refs.begin(), prim_refs.end());
    const auto found = find_by_sah(prim_refs, unit_cube);
    ASSERT_TRUE(expected && found);
    EXPECT_EQ(found->plane, expected->plane);
    EXPECT_EQ(found->planar_side, expected->planar_side);
    EXPECT_EQ(found->cost, expected->cost);
}

TEST(SahSweep, WorksAtAllScales) {
    for (const float scale : {1e-40F, 1e-30F, 1e30F, 1e38F}) {
        const auto box = [&](float from, float to) {
            return Aabb{{from * scale, 0, 0}, {to * scale, scale, scale}};
        };
        const std::vector<PrimRef> prim_refs{{box(0, 1), 0}, {box(0, 1), 1}, {box(2, 3), 2}};
        const auto split = find_by_sah(prim_refs, box(0, 3), {.empty_bonus = 0.0});
        ASSERT_TRUE(split.has_value()) << scale;
        EXPECT_EQ(split->plane.position, scale);
        EXPECT_NEAR(split->cost, 1.0 + 2.0 * 6.0 / 14.0 + 10.0 / 14.0, 1e-4);
    }
}

TEST(SahSweep, CutsAFlatNode) {
    const Aabb flat{{0, 0, 5}, {4, 1, 5}};
    const std::vector<PrimRef> prim_refs{{{{0, 0, 5}, {1, 1, 5}}, 0}, {{{3, 0, 5}, {4, 1, 5}}, 1}};
    const auto split = find_by_sah(prim_refs, flat, {.empty_bonus = 0.0});
    ASSERT_TRUE(split.has_value());
    EXPECT_EQ(split->plane.axis, Axis::x);
    EXPECT_DOUBLE_EQ(split->cost, 1.0 + 0.25 + 0.75);
}

}  // namespace
}  // namespace coppice::test
