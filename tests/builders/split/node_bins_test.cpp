#include "builders/split/node_bins.h"

#include "builders/kernels/kd_kernels.h"
#include "builders/prim_refs.h"

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
    auto prim_refs = make_prim_refs(Layout::random, 70'000, random);
    prim_refs[50'000].weight = 3.5F;
    const BinGrid grid = *bin_grid(unit_cube);
    const NodeBins in_chunks = bin_node(prim_refs, grid);
    NodeBins at_once;
    kd_kernels_for(Isa::scalar).bin_ends(prim_refs, grid, at_once);
    EXPECT_EQ(in_chunks, at_once);
    EXPECT_EQ(weight_in(at_once[0]), 70'002.5);
}

TEST(BestBoundary, SeparatesTwoClusters) {
    std::vector<PrimRef> prim_refs;
    for (std::uint32_t id = 0; id < 100; ++id) {
        const float x = id < 50 ? 0.0F : 0.75F;
        prim_refs.push_back({{{x, 0, 0}, {x + 0.25F, 1, 1}}, id});
    }
    const SplitQuery query{prim_refs, unit_cube, {}, 0.0};
    const NodeBins bins = bin_node(prim_refs, *bin_grid(unit_cube));
    const auto boundary = best_boundary(query, Axis::x, bins[0], 100.0);
    ASSERT_TRUE(boundary.has_value());
    EXPECT_GT(boundary->plane.position, 0.25F);
    EXPECT_LE(boundary->plane.position, 0.75F);
}

// The plane is at the end of a cluster, whichever the boundary between the bins.
TEST(BestEnd, SeparatesTwoClustersAtAnEnd) {
    std::vector<PrimRef> prim_refs;
    for (std::uint32_t id = 0; id < 100; ++id) {
        const float x = id < 30 ? 0.01F : 0.76F;
        prim_refs.push_back({{{x, 0, 0}, {x + 0.2F, 1, 1}}, id});
    }
    const NodeBins bins = bin_node(prim_refs, *bin_grid(unit_cube));
    const SahCostModel model{.empty_bonus = 0.0};
    const BinnedPlane best = best_end(bins[0], {}, PlaneEvaluator(unit_cube, Axis::x, model));
    EXPECT_EQ(best.split.plane, (SplitPlane{Axis::x, 0.76F}));
    EXPECT_EQ(best.split.planar_side, PlanarSide::above);
    EXPECT_NEAR(best.split.cost, naive_plane_cost(prim_refs, unit_cube, model, best.split.plane),
                1e-9);
}

}  // namespace
}  // namespace coppice::test
