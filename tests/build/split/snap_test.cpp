#include "build/split/snap.h"

#include "build/fragments.h"

#include <gtest/gtest.h>

namespace coppice::test {
namespace {

// Of all fragment ends in the two bins around a boundary the cheapest is found.
TEST(Snap, FindsTheCheapestEndNearBy_8) {
    Random random(8);
    const SahCostModel model{.empty_bonus = 0.3};
    for (const Layout layout : {Layout::random, Layout::grid, Layout::planar, Layout::points}) {
        const auto fragments = make_fragments(layout, 400, random);
        const SplitQuery query{fragments, unit_cube, model, 0.0};
        const BinGrid grid = *bin_grid(unit_cube);
        const NodeBins bins = bin_node(fragments, grid);
        for (std::size_t bin = 1; bin < bin_count; ++bin) {
            BestSplit best;
            const float at = static_cast<float>(bin) / static_cast<float>(bin_count);
            snap(query, grid, bins.axes[1], {{Axis::y, at}, bin, 0.0}, best);
            double expected = std::numeric_limits<double>::infinity();
            for (const Fragment& fragment : fragments) {
                for (const float end : {fragment.box.lower.y, fragment.box.upper.y}) {
                    const std::size_t end_bin = bin_of(end, 0.0F, 32.0F);
                    if (end_bin + 1 != bin && end_bin != bin) continue;
                    if (end <= 0.0F || end >= 1.0F) continue;
                    expected = std::min(
                        expected, naive_plane_cost(fragments, unit_cube, model, {Axis::y, end}));
                }
            }
            if (best.get()) {
                EXPECT_NEAR(best.cost(), expected, 1e-9 * expected);
            } else {
                EXPECT_EQ(expected, std::numeric_limits<double>::infinity());
            }
        }
    }
}

}  // namespace
}  // namespace coppice::test
