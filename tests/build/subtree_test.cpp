#include "build/subtree.h"

#include "coppice/base/error.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <stdexcept>

namespace coppice::test {
namespace {

using testing::ElementsAre;

constexpr Plane any_plane{Axis::y, 2.5F};

std::vector<Fragment> fragments_of(std::initializer_list<std::uint32_t> ids) {
    std::vector<Fragment> fragments;
    for (const std::uint32_t id : ids)
        fragments.push_back({Aabb{}, id});
    return fragments;
}

// An inner node over the leaves {ids, ids + 1} and {}.
Subtree small_subtree(std::uint32_t id) {
    Subtree tree;
    const std::uint32_t lower = make_inner(tree, 0, any_plane, PlanarSide::above);
    make_leaf(tree, lower, fragments_of({id, id + 1}));
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

TEST(Splice, ReplacesASlot) {
    Subtree tree = small_subtree(1);
    splice(tree, 2, small_subtree(5));
    EXPECT_THAT(tree.nodes, ElementsAre(KdNode::make_inner(any_plane, PlanarSide::above, 1),
                                        KdNode::make_leaf(0, 2),
                                        KdNode::make_inner(any_plane, PlanarSide::above, 3),
                                        KdNode::make_leaf(2, 2), KdNode::make_leaf(4, 0)));
    EXPECT_THAT(tree.references, ElementsAre(1, 2, 5, 6));
}

TEST(Splice, TakesALeaf) {
    Subtree tree = small_subtree(1);
    Subtree leaf;
    make_leaf(leaf, 0, fragments_of({9}));
    splice(tree, 2, leaf);
    EXPECT_EQ(tree.nodes.size(), 3U);
    EXPECT_EQ(tree.nodes[2], KdNode::make_leaf(2, 1));
    EXPECT_THAT(tree.references, ElementsAre(1, 2, 9));
}

TEST(Splice, KeepsWhatTheSampleHeld) {
    Subtree leaf;
    leaf.nodes[0] = KdNode::make_leaf(0, 0, SampleContent::none);
    Subtree tree = small_subtree(1);
    splice(tree, 2, leaf);
    EXPECT_EQ(tree.nodes[2].in_sample(), SampleContent::none);
}

TEST(BuildChildren, IsTheSameInPlaceAndInParallel) {
    const auto build = [](std::size_t fragment_count) {
        Subtree tree;
        const std::uint32_t lower = make_inner(tree, 0, any_plane, PlanarSide::below);
        const auto build_child = [](Subtree& part, std::uint32_t slot) {
            const std::uint32_t child = make_inner(part, slot, any_plane, PlanarSide::above);
            make_leaf(part, child, fragments_of({1, 2, 3}));
            make_leaf(part, child + 1, fragments_of({4}));
        };
        build_children(tree, lower, fragment_count, build_child, build_child);
        return tree;
    };
    const Subtree in_place = build(parallel_fragment_count - 1);
    const Subtree in_parallel = build(parallel_fragment_count);
    EXPECT_EQ(in_place.nodes, in_parallel.nodes);
    EXPECT_EQ(in_place.references, in_parallel.references);
    EXPECT_EQ(in_place.nodes.size(), 7U);
}

TEST(BuildChildren, PassesExceptionsOn) {
    for (const std::size_t count : {std::size_t{1}, parallel_fragment_count}) {
        Subtree tree;
        const std::uint32_t lower = make_inner(tree, 0, any_plane, PlanarSide::below);
        const auto fail = [](Subtree&, std::uint32_t) { throw Error(ErrorCode::limit, "full"); };
        EXPECT_THROW(build_children(tree, lower, count, fail, fail), Error);
    }
}

}  // namespace
}  // namespace coppice::test
