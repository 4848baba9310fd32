#include "coppice/tree/walk.h"

#include "tree/small_tree.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <tuple>
#include <vector>

namespace coppice::test {
namespace {

using testing::ElementsAre;
using testing::FieldsAre;

std::vector<VisitedNode> visited(const KdTree& tree) {
    std::vector<VisitedNode> nodes;
    walk(tree, [&](const VisitedNode& at) { nodes.push_back(at); });
    return nodes;
}

TEST(Walk, MeetsTheRootOfNothing) {
    EXPECT_THAT(visited(KdTree{}), ElementsAre(FieldsAre(0, Aabb{}, 0)));
}

TEST(Walk, MeetsParentsBeforeChildrenAndLowerBeforeUpper) {
    const auto box = [](float from, float to) { return Aabb{{from, 0, 0}, {to, 1, 1}}; };
    EXPECT_THAT(visited(parts_over_five_boxes().tree()),
                ElementsAre(FieldsAre(0, box(0, 7), 0), FieldsAre(1, box(0, 3.5F), 1),
                            FieldsAre(3, box(0, 1.5F), 2), FieldsAre(4, box(1.5F, 3.5F), 2),
                            FieldsAre(2, box(3.5F, 7), 1), FieldsAre(5, box(3.5F, 5.5F), 2),
                            FieldsAre(6, box(5.5F, 7), 2)));
}

TEST(Walk, CutsBoxesOnEveryAxis) {
    const KdTree tree(
        {inner_node(Axis::y, 0.25F, 1), inner_node(Axis::z, 0.5F, 3), KdNode{}, KdNode{}, KdNode{}},
        {}, {{0, 0, 0}, {1, 1, 1}});
    EXPECT_THAT(visited(tree), ElementsAre(FieldsAre(0, Aabb{{0, 0, 0}, {1, 1, 1}}, 0),
                                           FieldsAre(1, Aabb{{0, 0, 0}, {1, 0.25F, 1}}, 1),
                                           FieldsAre(3, Aabb{{0, 0, 0}, {1, 0.25F, 0.5F}}, 2),
                                           FieldsAre(4, Aabb{{0, 0, 0.5F}, {1, 0.25F, 1}}, 2),
                                           FieldsAre(2, Aabb{{0, 0.25F, 0}, {1, 1, 1}}, 1)));
}

TEST(WalkBelow, StartsAnywhere) {
    const KdTree tree = parts_over_five_boxes().tree();
    std::vector<std::tuple<std::uint32_t, int>> met;
    walk_below(tree.nodes(), {2, box_at(3.5F, 3.5F), 1},
               [&](const VisitedNode& at) { met.emplace_back(at.index, at.depth); });
    EXPECT_THAT(met, ElementsAre(FieldsAre(2, 1), FieldsAre(5, 2), FieldsAre(6, 2)));
}

}  // namespace
}  // namespace coppice::test
