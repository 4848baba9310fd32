#include "builders/split/exact_split.h"

#include "builders/prim_refs.h"

#include <gtest/gtest.h>

#include <limits>

namespace coppice::test {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

// Large and small nodes, all kinds of layouts: no PrimRef end on any axis costs less, and of equal
// ones the first by axis and position is taken.
TEST(ExactSplit, FindsTheFirstOfTheCheapestPlanes_7) {
    Random random(7);
    const SahCostModel model{.traversal = 1.0, .intersection = 2.0, .empty_bonus = 0.25};
    for (const Layout layout :
         {Layout::random, Layout::grid, Layout::planar, Layout::points, Layout::identical}) {
        for (const std::uint32_t count : {1U, 2U, 5U, 63U, 64U, 65U, 120U}) {
            const auto prim_refs = make_prim_refs(layout, count, random);
            double least = infinity;
            for (const Axis axis : all_axes) {
                for (const PrimRef& prim_ref : prim_refs) {
                    for (const float at : {prim_ref.box.lower[axis], prim_ref.box.upper[axis]}) {
                        if (!(at > 0.0F && at < 1.0F)) continue;
                        least = std::min(least,
                                         naive_plane_cost(prim_refs, unit_cube, model, {axis, at}));
                    }
                }
            }
            const auto split = ExactSplit().find({prim_refs, unit_cube, model, 0.0});
            ASSERT_EQ(split.has_value(), least < infinity);
            if (!split) continue;
            EXPECT_NEAR(split->cost, least, 1e-12 * least);
        }
    }
}

TEST(ExactSplit, TakesTheFirstOfEqualPlanes) {
    // The same on all axes, and from both sides.
    const std::vector<PrimRef> prim_refs{{{{0, 0, 0}, {0.25F, 0.25F, 0.25F}}, 0},
                                         {{{0.75F, 0.75F, 0.75F}, {1, 1, 1}}, 1}};
    const auto split = ExactSplit().find({prim_refs, unit_cube, {.empty_bonus = 0.0}, infinity});
    ASSERT_TRUE(split.has_value());
    EXPECT_EQ(split->plane, (SplitPlane{Axis::x, 0.25F}));
}

}  // namespace
}  // namespace coppice::test
