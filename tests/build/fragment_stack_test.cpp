#include "build/fragment_stack.h"

#include "support/meshes.h"
#include "support/random.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace coppice::test {
namespace {

bool same(std::span<const Fragment> a, const std::vector<Fragment>& b) {
    return std::equal(
        a.begin(), a.end(), b.begin(), b.end(), [](const Fragment& one, const Fragment& other) {
            return one.id == other.id && one.box == other.box && one.weight == other.weight;
        });
}

TEST(FragmentStack, DividesAsPartitionDoes_5) {
    const TriangleMesh mesh = make_soup(500, 0.3F, 5);
    const TriangleMeshView view = mesh.view();
    Random random(5);
    for (const PlanarSide side : {PlanarSide::below, PlanarSide::above}) {
        std::vector<Fragment> fragments = whole_fragments(view);
        fragments[7].weight = 3.0F;
        const Division division{view, Clipping::perfect};
        const Plane plane{Axis::y, random.uniform(0.2F, 0.8F)};
        const Plane next{Axis::x, random.uniform(0.2F, 0.8F)};
        const Partition expected = partition(fragments, plane, side, division);
        const Partition lower = partition(expected.below, next, side, division);
        const Partition upper = partition(expected.above, next, side, division);

        FragmentStack stack(fragments);
        const auto sides = stack.divide_top(fragments.size(), plane, side, division);
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

TEST(FragmentStack, DividesNothing) {
    const TriangleMesh mesh;
    FragmentStack stack({});
    const auto sides =
        stack.divide_top(0, {Axis::x, 1.0F}, PlanarSide::below, {mesh.view(), Clipping::perfect});
    EXPECT_EQ(sides.below, 0U);
    EXPECT_EQ(sides.above, 0U);
}

}  // namespace
}  // namespace coppice::test
