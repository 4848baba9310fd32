#include "builders/split/snap.h"

#include "builders/prim_refs.h"
#include "builders/split/axis_sweep.h"

#include <gtest/gtest.h>

namespace coppice::test {
namespace {

// Of the ends on the y axis in the bins on both sides of a boundary.
double cheapest_end(const std::vector<PrimRef>& prim_refs, std::size_t bin,
                    const SahCostModel& model) {
    double least = std::numeric_limits<double>::infinity();
    for (const PrimRef& prim_ref : prim_refs) {
        for (const float end : {prim_ref.box.lower.y, prim_ref.box.upper.y}) {
            const std::size_t end_bin = bin_of(end, 0.0F, 32.0F);
            if (end_bin + 1 != bin && end_bin != bin) continue;
            if (end <= 0.0F || end >= 1.0F) continue;
            least = std::min(least, naive_plane_cost(prim_refs, unit_cube, model, {Axis::y, end}));
        }
    }
    return least;
}

// Of all PrimRef ends in the two bins around a boundary the cheapest is found.
TEST(Snap, FindsTheCheapestEndNearBy_8) {
    Random random(8);
    const SahCostModel model{.empty_bonus = 0.3};
    for (const Layout layout : {Layout::random, Layout::grid, Layout::planar, Layout::points}) {
        const auto prim_refs = make_prim_refs(layout, 400, random);
        const SplitQuery query{prim_refs, unit_cube, model, 0.0};
        const BinGrid grid = *bin_grid(unit_cube);
        const NodeBins bins = bin_node(prim_refs, grid);
        for (std::size_t bin = 1; bin < bin_count; ++bin) {
            BinnedPlane coarse;
            coarse.split.plane.axis = Axis::y;
            coarse.bin = bin;
            const SplitCandidate split = snap(query, grid, bins[1], coarse);
            const double expected = cheapest_end(prim_refs, bin, model);
            if (expected == std::numeric_limits<double>::infinity()) {
                EXPECT_EQ(split.cost, expected);
            } else {
                EXPECT_NEAR(split.cost, expected, 1e-9 * expected);
            }
        }
    }
}

// Large nodes are searched in two steps, which find nearly the same.
TEST(Snap, ComesNearTheCheapestEndInLargeNodes_9) {
    Random random(9);
    const SahCostModel model{.empty_bonus = 0.3};
    for (const Layout layout : {Layout::random, Layout::points}) {
        auto prim_refs = make_prim_refs(layout, 20'000, random);
        const NodeBins bins = bin_node(prim_refs, *bin_grid(unit_cube));
        const PlaneEvaluator evaluator(unit_cube, Axis::z, model);
        const BinnedPlane coarse = best_end(bins[2], {}, evaluator);
        const SplitCandidate split =
            snap({prim_refs, unit_cube, model, 0.0}, *bin_grid(unit_cube), bins[2], coarse);
        EXPECT_LE(split.cost, coarse.split.cost);
        const auto exact = sweep_axis({prim_refs, unit_cube, model, 0.0}, Axis::z);
        EXPECT_LE(split.cost, 1.01 * exact->cost);
    }
}

}  // namespace
}  // namespace coppice::test
