#include "coppice/tree/kd_tree.h"

#include "coppice/base/error.h"

#include "support/tree_checks.h"
#include "tree/small_tree.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <utility>

namespace coppice::test {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

TEST(KdTree, OfNothingIsOneEmptyLeaf) {
    const KdTree tree;
    ASSERT_EQ(tree.nodes().size(), 1U);
    EXPECT_EQ(tree.root(), KdNode{});
    EXPECT_THAT(tree.references(), IsEmpty());
    EXPECT_THAT(tree.references(tree.root()), IsEmpty());
    EXPECT_TRUE(tree.bounds().is_empty());
    EXPECT_EQ(tree.byte_count(), 8U);
    EXPECT_EQ(tree, KdTree{});
}

TEST(KdTree, NeedsARoot) {
    try {
        const KdTree tree({}, {1, 2}, {});
        FAIL() << "no exception";
    } catch (const Error& error) {
        EXPECT_EQ(error.code(), ErrorCode::invalid_argument);
        EXPECT_STREQ(error.what(), "a k-d tree without nodes: pass at least a root");
    }
}

TEST(KdTree, KeepsWhatItIsGiven) {
    const TreeParts parts = parts_over_five_boxes();
    const KdTree tree = parts.tree();
    EXPECT_TRUE(std::equal(tree.nodes().begin(), tree.nodes().end(), parts.nodes.begin(),
                           parts.nodes.end()));
    EXPECT_THAT(tree.references(), ElementsAre(0, 4, 1, 4, 2, 3));
    EXPECT_EQ(tree.bounds(), parts.bounds);
    EXPECT_EQ(&tree.root(), &tree.nodes()[0]);
    EXPECT_EQ(tree.byte_count(), 7U * 8U + 6U * 4U);
    EXPECT_TRUE(is_in_order(tree));
}

TEST(KdTree, GivesALeafItsReferences) {
    const KdTree tree = parts_over_five_boxes().tree();
    EXPECT_THAT(tree.references(tree.nodes()[3]), ElementsAre(0, 4));
    EXPECT_THAT(tree.references(tree.nodes()[4]), ElementsAre(1, 4));
    EXPECT_THAT(tree.references(tree.nodes()[5]), ElementsAre(2));
    EXPECT_THAT(tree.references(tree.nodes()[6]), ElementsAre(3));
}

TEST(KdTree, ComparesAllOfIt) {
    const TreeParts parts = parts_over_five_boxes();
    EXPECT_EQ(parts.tree(), parts.tree());
    TreeParts other = parts;
    other.nodes[1] = inner_node(Axis::x, 1.25F, 3);
    EXPECT_NE(parts.tree(), other.tree());
    other = parts;
    other.references[5] = 2;
    EXPECT_NE(parts.tree(), other.tree());
    other = parts;
    other.bounds.upper.z = 2.0F;
    EXPECT_NE(parts.tree(), other.tree());
}

TEST(Skeleton, KeepsPlanesAndDropsReferences) {
    KdTree tree = parts_over_five_boxes().tree();
    const Skeleton skeleton(std::move(tree));
    const TreeParts parts = parts_over_five_boxes();
    ASSERT_EQ(skeleton.nodes().size(), parts.nodes.size());
    for (std::size_t i = 0; i < 3; ++i) {
        EXPECT_EQ(skeleton.nodes()[i], parts.nodes[i]);
    }
    for (std::size_t i = 3; i < 7; ++i) {
        EXPECT_EQ(skeleton.nodes()[i], KdNode{});
    }
    EXPECT_EQ(skeleton.bounds(), parts.bounds);
}

TEST(Skeleton, LeavesAnEmptyTreeBehind) {
    KdTree tree = parts_over_five_boxes().tree();
    const Skeleton skeleton(std::move(tree));
    EXPECT_EQ(tree, KdTree{});  // NOLINT(bugprone-use-after-move): documented to free its arrays
}

TEST(Skeleton, RemembersWhichLeavesWereEmpty) {
    TreeParts parts = parts_over_five_boxes();
    parts.nodes[4] = KdNode::make_leaf(2, 0);
    const Skeleton skeleton(parts.tree());
    EXPECT_EQ(skeleton.nodes()[3].in_sample(), SampleContent::some);
    EXPECT_EQ(skeleton.nodes()[4].in_sample(), SampleContent::none);
    EXPECT_EQ(skeleton.nodes()[4].reference_count(), 0U);
}

TEST(Skeleton, OfNothingIsALeaf) {
    const Skeleton skeleton{KdTree{}};
    ASSERT_EQ(skeleton.nodes().size(), 1U);
    EXPECT_TRUE(skeleton.nodes()[0].is_leaf());
    EXPECT_EQ(skeleton.nodes()[0].in_sample(), SampleContent::none);
}

TEST(Skeleton, GivesUpItsNodes) {
    Skeleton skeleton(parts_over_five_boxes().tree());
    EXPECT_EQ(std::move(skeleton).release_nodes().size(), 7U);
}

}  // namespace
}  // namespace coppice::test
