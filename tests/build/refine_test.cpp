#include "coppice/build/refine.h"

#include "coppice/build/build_on_sample.h"
#include "coppice/build/draw_sample.h"
#include "coppice/build/empty_leaves.h"
#include "coppice/build/refill.h"

#include "support/meshes.h"

#include <gtest/gtest.h>

#include <utility>

namespace coppice::test {
namespace {

KdTree refilled_tree(const TriangleMesh& mesh, const BuildOptions& options) {
    const Sample sample = draw_sample(mesh.view(), options.sample);
    return refill(empty_leaves(build_on_sample(mesh.view(), sample, options)), mesh.view(),
                  options);
}

TEST(Refine, WithoutGrowthReturnsTheTree) {
    const TriangleMesh mesh = make_soup(500, 0.1F, 1);
    const BuildOptions options{.sample = {.rate = 0.1}, .growth = Growth::none};
    const KdTree tree = refilled_tree(mesh, options);
    EXPECT_TRUE(refine(KdTree(tree), mesh.view(), options) == tree);
}

TEST(Refine, WithKdGrowthIsGrowKd) {
    const TriangleMesh mesh = make_soup(500, 0.1F, 1);
    const BuildOptions options{.sample = {.rate = 0.1}, .growth = Growth::kd};
    const KdTree tree = refilled_tree(mesh, options);
    const KdTree grown = grow_kd(KdTree(tree), mesh.view(), options);
    EXPECT_TRUE(refine(KdTree(tree), mesh.view(), options) == grown);
    EXPECT_FALSE(grown == tree);
}

}  // namespace
}  // namespace coppice::test
