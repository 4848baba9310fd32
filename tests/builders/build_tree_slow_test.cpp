#include "coppice/builders/build_tree.h"

#include "support/meshes.h"
#include "support/scene_matrix.h"
#include "support/tree_checks.h"

#include <gtest/gtest.h>

namespace coppice::test {
namespace {

class BuildLarge : public testing::TestWithParam<NamedScene> {};

TEST_P(BuildLarge, IsSoundAndTheSameForAnyThreads) {
    const TriangleMesh mesh = GetParam().make();
    for (const char* const rule : {"sah", "median", "midpoint"}) {
        for (const double rate : {1.0, 0.01}) {
            for (const LeafRefinement leaf_refinement :
                 {LeafRefinement::none, LeafRefinement::kd}) {
                KdOptions options{.sample = {.rate = rate},
                                  .split = {.rule = rule},
                                  .leaf_refinement = leaf_refinement};
                const KdTree tree = build_kd_tree(mesh.view(), options).tree;
                EXPECT_TRUE(is_sound(tree, mesh.view())) << rule << " at " << rate;
                options.threads = 1;
                EXPECT_TRUE(build_kd_tree(mesh.view(), options).tree == tree)
                    << rule << " at " << rate;
            }
        }
    }
}

INSTANTIATE_TEST_SUITE_P(
    Seed5, BuildLarge,
    testing::Values(NamedScene{"duplicates_65536",
                               [] {
                                   return joined(make_soup(1000, 0.1F, 5),
                                                 repeated(make_soup(1, 0.5F, 5), 65'536));
                               }},
                    NamedScene{"huge_among_20000_small",
                               [] {
                                   return joined(make_triangle({Vec3f{-9, -9, -1}, Vec3f{9, -9, 1},
                                                                Vec3f{0, 9, 0.5F}}),
                                                 make_soup(20'000, 0.02F, 5));
                               }},
                    NamedScene{"needles_3000", [] { return make_needles(3000, 5); }},
                    NamedScene{"boxes", [] { return make_boxes(14); }}),
    scene_name);

}  // namespace
}  // namespace coppice::test
