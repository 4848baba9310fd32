#include "build/kernels/bin_ends.h"

#include "build/fragments.h"

#include <gtest/gtest.h>

namespace coppice::test {
namespace {

TEST(BinOf, IsMonotoneAndStaysInside) {
    EXPECT_EQ(bin_of(-5.0F, 0.0F, 32.0F), 0U);
    EXPECT_EQ(bin_of(0.0F, 0.0F, 32.0F), 0U);
    EXPECT_EQ(bin_of(0.5F, 0.0F, 32.0F), 16U);
    EXPECT_EQ(bin_of(1.0F, 0.0F, 32.0F), 31U);
    EXPECT_EQ(bin_of(9.0F, 0.0F, 32.0F), 31U);
    EXPECT_EQ(bin_of(0.7F, 0.0F, 0.0F), 0U) << "an axis without extent";
}

TEST(BinEnds, CountsAllEnds_4) {
    Random random(4);
    const BinGrid grid{{0, 0, 0}, {32, 32, 32}};
    for (const Layout layout : {Layout::random, Layout::grid, Layout::planar, Layout::points}) {
        auto fragments = make_fragments(layout, 300, random);
        fragments[3].weight = 5.0F;
        NodeBins bins;
        bin_ends(fragments, grid, bins);
        NodeBins expected;
        for (const Fragment& fragment : fragments) {
            for (const Axis axis : all_axes) {
                AxisBins& axis_bins = expected[static_cast<std::size_t>(axis)];
                const float start = fragment.box.lower[axis];
                const float end = fragment.box.upper[axis];
                axis_bins.add_start(bin_of(start, 0.0F, 32.0F), start, fragment.weight);
                axis_bins.add_end(bin_of(end, 0.0F, 32.0F), end, fragment.weight);
            }
        }
        EXPECT_EQ(bins, expected);
    }
}

}  // namespace
}  // namespace coppice::test
