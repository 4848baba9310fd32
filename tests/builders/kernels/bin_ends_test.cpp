#include "builders/kernels/bin_ends.h"

#include "builders/kernels/kd_kernels.h"
#include "builders/prim_refs.h"

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
        auto prim_refs = make_prim_refs(layout, 300, random);
        prim_refs[3].weight = 5.0F;
        NodeBins expected;
        for (const PrimRef& prim_ref : prim_refs) {
            for (const Axis axis : all_axes) {
                AxisBins& axis_bins = expected[static_cast<std::size_t>(axis)];
                const float start = prim_ref.box.lower[axis];
                const float end = prim_ref.box.upper[axis];
                axis_bins.add_start(bin_of(start, 0.0F, 32.0F), start, prim_ref.weight);
                axis_bins.add_end(bin_of(end, 0.0F, 32.0F), end, prim_ref.weight);
            }
        }
        for (const Isa isa : available_isas()) {
            NodeBins bins;
            kd_kernels_for(isa).bin_ends(prim_refs, grid, bins);
            EXPECT_EQ(bins, expected) << name_of(isa);
        }
    }
}

}  // namespace
}  // namespace coppice::test
