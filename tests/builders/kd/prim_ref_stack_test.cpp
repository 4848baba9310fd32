#include "builders/kd/prim_ref_stack.h"

#include "support/meshes.h"
#include "support/random.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace coppice::test {
namespace {

bool same(std::span<const PrimRef> a, const std::vector<PrimRef>& b) {
    return std::equal(
        a.begin(), a.end(), b.begin(), b.end(), [](const PrimRef& one, const PrimRef& other) {
            return one.id == other.id && one.box == other.box && one.weight == other.weight;
        });
}

TEST(PrimRefStack, DividesAsPartitionDoes_5) {
    const TriangleMesh mesh = make_soup(500, 0.3F, 5);
    const TriangleMeshView view = mesh.view();
    Random random(5);
    for (const PlanarSide side : {PlanarSide::below, PlanarSide::above}) {
        std::vector<PrimRef> prim_refs = whole_prim_refs(view);
        prim_refs[7].weight = 3.0F;
        const Division division{view, Clipping::perfect};
        const SplitPlane plane{Axis::y, random.uniform(0.2F, 0.8F)};
        const SplitPlane next{Axis::x, random.uniform(0.2F, 0.8F)};
        const Partition expected = partition(prim_refs, plane, side, division);
        const Partition lower = partition(expected.below, next, side, division);
        const Partition upper = partition(expected.above, next, side, division);

        PrimRefStack stack(prim_refs);
        const auto sides = stack.divide_top(prim_refs.size(), plane, side, division);
        EXPECT_TRUE(same(stack.top(sides.below), expected.below));
        const auto lower_sides = stack.divide_top(sides.below, next, side, division);
        EXPECT_TRUE(same(stack.top(lower_sides.below), lower.below));
        stack.pop(lower_sides.below);
        EXPECT_TRUE(same(stack.top(lower_sides.above), lower.above));
        stack.pop(lower_sides.above);
        EXPECT_TRUE(same(stack.top(sides.above), expected.above));
        const auto upper_sides = stack.divide_top(sides.above, next, side, division);
        EXPECT_TRUE(same(stack.top(upper_sides.below), upper.below));
        stack.pop(upper_sides.below);
        EXPECT_TRUE(same(stack.top(upper_sides.above), upper.above));
    }
}

TEST(PrimRefStack, DividesNothing) {
    const TriangleMesh mesh;
    PrimRefStack stack({});
    const auto sides =
        stack.divide_top(0, {Axis::x, 1.0F}, PlanarSide::below, {mesh.view(), Clipping::perfect});
    EXPECT_EQ(sides.below, 0U);
    EXPECT_EQ(sides.above, 0U);
}

}  // namespace
}  // namespace coppice::test
