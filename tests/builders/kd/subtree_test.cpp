#include "builders/kd/subtree.h"

#include "coppice/base/error.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace coppice::test {
namespace {

using testing::ElementsAre;

constexpr SplitPlane any_plane{Axis::y, 2.5F};

std::vector<PrimRef> prim_refs_of(std::initializer_list<std::uint32_t> ids) {
    std::vector<PrimRef> prim_refs;
    for (const std::uint32_t id : ids) {
        prim_refs.push_back({Aabb{}, id});
    }
    return prim_refs;
}

// An inner node over the leaves {ids, ids + 1} and {}.
Subtree small_subtree(std::uint32_t id) {
    Subtree tree;
    const std::uint32_t lower = make_inner(tree, 0, any_plane, PlanarSide::above);
    make_leaf(tree, lower, prim_refs_of({id, id + 1}));
    make_leaf(tree, lower + 1, {});
    return tree;
}

TEST(Subtree, IsAnEmptyLeafAtFirst) {
    const Subtree tree;
    EXPECT_THAT(tree.nodes, ElementsAre(KdNode{}));
    EXPECT_TRUE(tree.references.empty());
}

TEST(Subtree, GrowsBySlots) {
    const Subtree tree = small_subtree(7);
    EXPECT_THAT(tree.nodes, ElementsAre(KdNode::make_inner(any_plane, PlanarSide::above, 1),
                                        KdNode::make_leaf(0, 2), KdNode::make_leaf(2, 0)));
    EXPECT_THAT(tree.references, ElementsAre(7, 8));
}

TEST(Relocated, MovesIndicesOnly) {
    EXPECT_EQ(relocated(KdNode::make_leaf(3, 2, SampleContent::none), 100, 10),
              KdNode::make_leaf(13, 2, SampleContent::none));
    EXPECT_EQ(relocated(KdNode::make_inner(any_plane, PlanarSide::above, 3), 100, 10),
              KdNode::make_inner(any_plane, PlanarSide::above, 103));
}

TEST(RequirePossible, KnowsTheLimits) {
    EXPECT_NO_THROW(require_possible(KdNode::max_payload, 0xffffffffU));
    EXPECT_THROW(require_possible(KdNode::max_payload + 1ULL, 0), Error);
    EXPECT_THROW(require_possible(1, 1ULL << 32), Error);
}

}  // namespace
}  // namespace coppice::test
