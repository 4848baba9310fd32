#include "builders/kd/exact/classify.h"

#include "support/sphere_set.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace coppice::test {
namespace {

using testing::ElementsAre;

constexpr Aabb at(float lower, float upper) {
    return {{lower, 0, 0}, {upper, 1, 1}};
}

TEST(Classify, SaysWhereEachWent) {
    const BoxSet boxes({at(0, 1), at(1, 3), at(2, 2), at(3, 4)});
    const ExactNode node = make_exact_node(whole_prim_refs(boxes));
    const Division division{boxes, Clipping::perfect};
    constexpr std::uint32_t upper = Classification::in_upper_child;
    Partition sides;
    const Classification low = classify(node, {Axis::x, 2.0F}, PlanarSide::below, division, sides);
    EXPECT_THAT(low.moved_to, ElementsAre(0, Classification::moved_anew, 2, 1 | upper));
    EXPECT_THAT(low.clipped_below, ElementsAre(1));
    EXPECT_THAT(low.clipped_above, ElementsAre(0));
    EXPECT_EQ(sides.below.size(), 3U);
    EXPECT_EQ(sides.above.size(), 2U);
    Partition other_sides;
    const Classification high =
        classify(node, {Axis::x, 2.0F}, PlanarSide::above, division, other_sides);
    EXPECT_THAT(high.moved_to, ElementsAre(0, Classification::moved_anew, 1 | upper, 2 | upper));
}

}  // namespace
}  // namespace coppice::test
