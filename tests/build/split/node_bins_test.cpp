#include "build/split/node_bins.h"

#include "build/fragments.h"

#include <gtest/gtest.h>

namespace coppice::test {
namespace {

TEST(BinGrid, CoversTheBoxOrIsRefused) {
    const auto grid = bin_grid({{1, 2, 3}, {2, 6, 3}});
    ASSERT_TRUE(grid.has_value());
    EXPECT_EQ(grid->origin, (Vec3f{1, 2, 3}));
    EXPECT_EQ(grid->bins_per_unit, (Vec3f{32, 8, 0}));
    EXPECT_FALSE(bin_grid({{0, 0, 0}, {1, 1, 1e-35F}}).has_value());
    EXPECT_FALSE(bin_grid({{0, 0, -3e38F}, {1, 1, 3e38F}}).has_value());
}

TEST(BinNode, IsTheSameInChunks_1) {
    Random random(1);
    auto fragments = make_fragments(Layout::random, 70'000, random);
    fragments[50'000].weight = 3.5F;
    const BinGrid grid = *bin_grid(unit_cube);
    const NodeBins in_chunks = bin_node(fragments, grid);
    NodeBins at_once;
    bin_ends(fragments, grid, at_once);
    EXPECT_EQ(in_chunks.extent, at_once.extent);
    for (std::size_t axis = 0; axis < 3; ++axis) {
        EXPECT_EQ(in_chunks.axes[axis].starts, at_once.axes[axis].starts);
        EXPECT_EQ(in_chunks.axes[axis].ends, at_once.axes[axis].ends);
    }
}

TEST(BestBoundary, SeparatesTwoClusters) {
    std::vector<Fragment> fragments;
    for (std::uint32_t id = 0; id < 100; ++id) {
        const float x = id < 50 ? 0.0F : 0.75F;
        fragments.push_back({{{x, 0, 0}, {x + 0.25F, 1, 1}}, id});
    }
    const SplitQuery query{fragments, unit_cube, {}, 0.0};
    const NodeBins bins = bin_node(fragments, *bin_grid(unit_cube));
    const auto boundary = best_boundary(query, Axis::x, bins.axes[0], 100.0);
    ASSERT_TRUE(boundary.has_value());
    EXPECT_GT(boundary->plane.position, 0.25F);
    EXPECT_LE(boundary->plane.position, 0.75F);
}

}  // namespace
}  // namespace coppice::test
