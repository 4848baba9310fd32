#include "coppice/builders/empty_leaves.h"

#include "coppice/builders/build_on_sample.h"
#include "coppice/builders/draw_sample.h"

#include "support/meshes.h"

#include <gtest/gtest.h>

#include <utility>

namespace coppice::test {
namespace {

TEST(EmptyLeaves, KeepsThePlanesAndNothingElse) {
    const TriangleMesh mesh = make_soup(500, 0.1F, 1);
    const KdOptions options{.sample = {.rate = 0.2}, .split = {.max_leaf = 2}};
    const KdTree tree =
        build_on_sample(mesh.view(), draw_sample(mesh.view(), options.sample), options);
    const Skeleton skeleton = empty_leaves(KdTree(tree));
    EXPECT_EQ(skeleton.bounds(), tree.bounds());
    ASSERT_EQ(skeleton.nodes().size(), tree.nodes().size());
    int emptied = 0;
    for (std::size_t i = 0; i < tree.nodes().size(); ++i) {
        const KdNode& before = tree.nodes()[i];
        const KdNode& after = skeleton.nodes()[i];
        if (!before.is_leaf()) {
            EXPECT_EQ(after, before);
            continue;
        }
        ASSERT_TRUE(after.is_leaf());
        EXPECT_EQ(after.reference_count(), 0U);
        EXPECT_EQ(after.in_sample() == SampleContent::none, before.reference_count() == 0);
        emptied += before.reference_count() > 0 ? 1 : 0;
    }
    EXPECT_GT(emptied, 10);
}

TEST(EmptyLeaves, OfNothingIsAnEmptyLeaf) {
    EXPECT_EQ(empty_leaves(KdTree{}).nodes().size(), 1U);
}

}  // namespace
}  // namespace coppice::test
