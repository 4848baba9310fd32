// Planes at 0 were -0 or +0 as the parallel sort of events happened to leave them: trees of 1 and
// of 2 threads compared unequal.

#include "coppice/builders/build_tree.h"

#include "support/meshes.h"
#include "support/random.h"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

namespace coppice::test {
namespace {

// Triangles that start or end at x = 0, of either sign.
TriangleMesh make_both_sides_of_zero(std::uint32_t count, std::uint64_t seed) {
    Random random(seed);
    TriangleMesh mesh;
    for (std::uint32_t i = 0; i < count; ++i) {
        const float zero = random.below(2) == 0 ? 0.0F : -0.0F;
        const float far =
            random.below(2) == 0 ? random.uniform(0.5F, 1) : random.uniform(-1, -0.5F);
        const float y = random.uniform(0, 0.1F);
        add_triangle(mesh, {Vec3f{zero, y, 0}, Vec3f{far, y, 0}, Vec3f{far, y, 0.1F}});
    }
    return mesh;
}

class NegativeZeroPlane : public testing::TestWithParam<std::uint64_t> {};

TEST_P(NegativeZeroPlane, IsTheSameForAnyThreads) {
    const TriangleMesh mesh = make_both_sides_of_zero(20'000, GetParam());
    KdOptions options{
        .split = {.max_depth = 1}, .leaf_refinement = LeafRefinement::none, .threads = 1};
    const KdTree expected = build_kd_tree(mesh.view(), options).tree;
    ASSERT_EQ(expected.root().plane(), (SplitPlane{Axis::x, 0.0F}));
    EXPECT_FALSE(std::signbit(expected.root().position()));
    options.threads = 2;
    for (int i = 0; i < 5; ++i) {
        EXPECT_TRUE(build_kd_tree(mesh.view(), options).tree == expected);
    }
}

INSTANTIATE_TEST_SUITE_P(Seed, NegativeZeroPlane, testing::Values(1U, 2U, 3U, 4U, 5U),
                         [](const auto& each) { return std::to_string(each.param); });

}  // namespace
}  // namespace coppice::test
