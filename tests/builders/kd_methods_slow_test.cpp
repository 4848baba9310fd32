// The k-d methods on the extremes: a 65,536-fold duplicate, one huge triangle among a million
// small.

#include "coppice/builders/build_tree.h"
#include "coppice/builders/method.h"

#include "support/meshes.h"
#include "support/scene_matrix.h"
#include "support/tree_checks.h"

#include <gtest/gtest.h>

namespace coppice::test {
namespace {

class KdMethodsLarge : public testing::TestWithParam<NamedScene> {};

TEST_P(KdMethodsLarge, AreSoundAndBounded) {
    const TriangleMesh mesh = GetParam().make();
    for (const char* const method : {"exact", "binned", "sampled", "subsampled", "adaptive"}) {
        const KdTree tree = build_kd_tree(mesh.view(), find_method(method).kd_options()).tree;
        EXPECT_TRUE(is_sound(tree, mesh.view())) << method;
        EXPECT_LT(tree.references().size(), 64 * mesh.triangles.size()) << method;
    }
}

INSTANTIATE_TEST_SUITE_P(
    Seed5, KdMethodsLarge,
    testing::Values(NamedScene{"duplicates_65536",
                               [] {
                                   return joined(make_soup(1000, 0.1F, 5),
                                                 repeated(make_soup(1, 0.5F, 5), 65'536));
                               }},
                    NamedScene{"huge_among_a_million",
                               [] {
                                   return joined(make_triangle({Vec3f{-9, -9, -1}, Vec3f{9, -9, 1},
                                                                Vec3f{0, 9, 0.5F}}),
                                                 make_soup(1'000'000, 0.005F, 5));
                               }},
                    NamedScene{"needles_3000", [] { return make_needles(3000, 5); }},
                    NamedScene{"slivers_3000", [] { return make_slivers(3000, 1e-6F, 5); }}),
    scene_name);

}  // namespace
}  // namespace coppice::test
