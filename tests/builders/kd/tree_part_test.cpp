#include "builders/kd/tree_part.h"

#include "coppice/base/error.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace coppice::test {
namespace {

using testing::ElementsAre;

constexpr SplitPlane split_plane{Axis::y, 2.5F};

TreePart leaf_of(const std::vector<std::uint32_t>& ids) {
    std::vector<PrimRef> prim_refs;
    prim_refs.reserve(ids.size());
    for (const std::uint32_t id : ids) {
        prim_refs.push_back({Aabb{}, id});
    }
    Subtree leaf;
    make_leaf(leaf, 0, prim_refs);
    return TreePart(std::move(leaf));
}

// An inner node over the leaves {id, id + 1} and {}, in one piece.
TreePart pair_of(std::uint32_t id) {
    Subtree tree;
    const std::uint32_t lower = make_inner(tree, 0, split_plane, PlanarSide::above);
    make_leaf(tree, lower, std::vector<PrimRef>{{Aabb{}, id}, {Aabb{}, id + 1}});
    make_leaf(tree, lower + 1, {});
    return TreePart(std::move(tree));
}

TEST(TreePart, IsAnEmptyLeafAtFirst) {
    const Subtree whole = assemble(TreePart());
    EXPECT_THAT(whole.nodes, ElementsAre(KdNode{}));
    EXPECT_TRUE(whole.references.empty());
}

TEST(Assemble, PutsPiecesInOrder) {
    const SplitPlane root{Axis::x, 1.0F};
    const Subtree whole =
        assemble(TreePart(root, PlanarSide::below, pair_of(1),
                          TreePart(split_plane, PlanarSide::below, leaf_of({8, 9}), pair_of(5))));
    EXPECT_THAT(whole.nodes, ElementsAre(KdNode::make_inner(root, PlanarSide::below, 1),
                                         KdNode::make_inner(split_plane, PlanarSide::above, 3),
                                         KdNode::make_inner(split_plane, PlanarSide::below, 5),
                                         KdNode::make_leaf(0, 2), KdNode::make_leaf(2, 0),
                                         KdNode::make_leaf(2, 2),
                                         KdNode::make_inner(split_plane, PlanarSide::above, 7),
                                         KdNode::make_leaf(4, 2), KdNode::make_leaf(6, 0)));
    EXPECT_THAT(whole.references, ElementsAre(1, 2, 8, 9, 5, 6));
}

TEST(Assemble, KeepsWhatTheSampleHeld) {
    Subtree leaf;
    leaf.nodes[0] = KdNode::make_leaf(0, 0, SampleContent::none);
    const Subtree whole =
        assemble(TreePart(split_plane, PlanarSide::below, leaf_of({1}), TreePart(std::move(leaf))));
    EXPECT_EQ(whole.nodes[2].in_sample(), SampleContent::none);
}

TEST(BuildBoth, IsTheSameInParallel) {
    const auto build = [](std::size_t prim_ref_count) {
        return assemble(build_both(
            split_plane, PlanarSide::below, prim_ref_count, [] { return pair_of(1); },
            [] { return pair_of(4); }));
    };
    const Subtree one_by_one = build(parallel_prim_ref_count - 1);
    const Subtree in_parallel = build(parallel_prim_ref_count);
    EXPECT_EQ(one_by_one.nodes, in_parallel.nodes);
    EXPECT_EQ(one_by_one.references, in_parallel.references);
}

TEST(BuildBoth, PassesExceptionsOn) {
    const auto fail = []() -> TreePart { throw Error(ErrorCode::limit, "full"); };
    for (const std::size_t count : {std::size_t{1}, parallel_prim_ref_count}) {
        EXPECT_THROW(
            static_cast<void>(build_both(split_plane, PlanarSide::below, count, fail, fail)),
            Error);
    }
}

}  // namespace
}  // namespace coppice::test
