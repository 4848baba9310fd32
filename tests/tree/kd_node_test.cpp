#include "coppice/tree/kd_node.h"

#include "support/random.h"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <limits>

namespace coppice::test {
namespace {

constexpr std::uint32_t most = KdNode::max_payload;

TEST(KdNode, IsAnEmptyLeafByDefault) {
    const KdNode node;
    EXPECT_TRUE(node.is_leaf());
    EXPECT_EQ(node.reference_count(), 0U);
    EXPECT_EQ(node.first_reference(), 0U);
    EXPECT_EQ(node.in_sample(), SampleContent::some);
    EXPECT_EQ(node, KdNode::make_leaf(0, 0));
}

TEST(KdNode, LeavesKeepTheirRange) {
    for (const std::uint32_t first : {0U, 1U, most, 0xfffffffeU, 0xffffffffU}) {
        for (const std::uint32_t count : {0U, 1U, 2U, most - 1, most}) {
            for (const SampleContent content : {SampleContent::some, SampleContent::none}) {
                const KdNode node = KdNode::make_leaf(first, count, content);
                EXPECT_TRUE(node.is_leaf());
                EXPECT_EQ(node.first_reference(), first);
                EXPECT_EQ(node.reference_count(), count);
                EXPECT_EQ(node.in_sample(), content);
            }
        }
    }
}

TEST(KdNode, InnerNodesKeepPlaneSideAndChild) {
    for (const Axis axis : all_axes) {
        for (const PlanarSide side : {PlanarSide::below, PlanarSide::above}) {
            for (const std::uint32_t child : {0U, 1U, 2U, most - 1, most}) {
                for (const float position : {0.0F, 1.0F, -1e-45F, 3.4e38F, -1e-30F}) {
                    const KdNode node = KdNode::make_inner({axis, position}, side, child);
                    EXPECT_FALSE(node.is_leaf());
                    EXPECT_EQ(node.axis(), axis);
                    EXPECT_EQ(node.position(), position);
                    EXPECT_EQ(node.plane(), (SplitPlane{axis, position}));
                    EXPECT_EQ(node.planar_side(), side);
                    EXPECT_EQ(node.lower_child(), child);
                    EXPECT_EQ(node.upper_child(), child + 1);
                }
            }
        }
    }
}

TEST(KdNode, KeepsEveryBitOfThePosition) {
    const auto kept_bits = [](std::uint32_t bits) {
        const SplitPlane plane{Axis::z, std::bit_cast<float>(bits)};
        const KdNode node = KdNode::make_inner(plane, PlanarSide::above, 12345);
        return std::bit_cast<std::uint32_t>(node.position());
    };
    for (const float position : {-0.0F, 0.0F, std::numeric_limits<float>::infinity(), -1.5F}) {
        const auto bits = std::bit_cast<std::uint32_t>(position);
        EXPECT_EQ(kept_bits(bits), bits);
    }
    Random random(1);
    for (int i = 0; i < 1000; ++i) {
        const auto bits = static_cast<std::uint32_t>(random.bits()) & 0xff7fffffU;  // no NaN
        EXPECT_EQ(kept_bits(bits), bits);
    }
}

TEST(KdNode, EqualsOnlyItself) {
    const KdNode leaf = KdNode::make_leaf(1, 2);
    EXPECT_EQ(leaf, KdNode::make_leaf(1, 2));
    EXPECT_NE(leaf, KdNode::make_leaf(2, 2));
    EXPECT_NE(leaf, KdNode::make_leaf(1, 3));
    EXPECT_NE(leaf, KdNode::make_leaf(1, 2, SampleContent::none));
    const KdNode inner = KdNode::make_inner({Axis::x, 0.0F}, PlanarSide::below, 1);
    EXPECT_EQ(inner, KdNode::make_inner({Axis::x, 0.0F}, PlanarSide::below, 1));
    EXPECT_NE(inner, KdNode::make_inner({Axis::y, 0.0F}, PlanarSide::below, 1));
    EXPECT_NE(inner, KdNode::make_inner({Axis::x, -0.0F}, PlanarSide::below, 1));  // bit for bit
    EXPECT_NE(inner, KdNode::make_inner({Axis::x, 0.0F}, PlanarSide::above, 1));
    EXPECT_NE(inner, KdNode::make_inner({Axis::x, 0.0F}, PlanarSide::below, 3));
    EXPECT_NE(inner, KdNode::make_leaf(0, 1));
}

}  // namespace
}  // namespace coppice::test
