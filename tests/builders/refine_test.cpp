#include "coppice/builders/refine.h"

#include "coppice/builders/build_on_sample.h"
#include "coppice/builders/draw_sample.h"
#include "coppice/builders/empty_leaves.h"
#include "coppice/builders/refill.h"

#include "support/meshes.h"

#include <gtest/gtest.h>

#include <utility>

namespace coppice::test {
namespace {

KdTree refilled_tree(const TriangleMesh& mesh, const KdOptions& options) {
    const Sample sample = draw_sample(mesh.view(), options.sample);
    return refill(empty_leaves(build_on_sample(mesh.view(), sample, options)), mesh.view(),
                  options);
}

TEST(Refine, WithoutGrowthReturnsTheTree) {
    const TriangleMesh mesh = make_soup(500, 0.1F, 1);
    const KdOptions options{.sample = {.rate = 0.1}, .leaf_refinement = LeafRefinement::none};
    const KdTree tree = refilled_tree(mesh, options);
    EXPECT_TRUE(refine(KdTree(tree), mesh.view(), options) == tree);
}

TEST(Refine, WithKdGrowthIsGrowKd) {
    const TriangleMesh mesh = make_soup(500, 0.1F, 1);
    const KdOptions options{.sample = {.rate = 0.1}, .leaf_refinement = LeafRefinement::kd};
    const KdTree tree = refilled_tree(mesh, options);
    const KdTree grown = grow_kd(KdTree(tree), mesh.view(), options);
    EXPECT_TRUE(refine(KdTree(tree), mesh.view(), options) == grown);
    EXPECT_FALSE(grown == tree);
}

}  // namespace
}  // namespace coppice::test
