// What growing is for, on meshes large enough for a sample of 1 % to mean something.

#include "coppice/builders/build_tree.h"

#include "support/meshes.h"
#include "support/random.h"
#include "support/scene_matrix.h"
#include "support/tree_checks.h"

#include <gtest/gtest.h>

namespace coppice::test {
namespace {

double grown_cost(const TriangleMesh& mesh, double rate, std::uint64_t seed) {
    const auto [tree, report] = build_kd_tree(mesh.view(), {.sample = {.rate = rate, .seed = seed},
                                                            .leaf_refinement = LeafRefinement::kd});
    EXPECT_TRUE(is_sound(tree, mesh.view()));
    return report.statistics.sah_cost;
}

class GrownFromOnePercent : public testing::TestWithParam<NamedScene> {};

TEST_P(GrownFromOnePercent, CostsWithinFivePercentOfTheFullTree) {
    const TriangleMesh mesh = GetParam().make();
    const double full_cost = grown_cost(mesh, 1.0, 1);
    for (const std::uint64_t seed : {1U, 2U}) {
        EXPECT_LT(grown_cost(mesh, 0.01, seed), 1.05 * full_cost) << "seed " << seed;
    }
}

// Spheres of different sizes on a floor.
TriangleMesh make_spheres_on_floor() {
    TriangleMesh mesh = make_terrain(150, 3);
    Random random(4);
    for (int i = 0; i < 20; ++i) {
        TriangleMesh sphere = scaled(make_sphere(40, 40), random.uniform(0.01F, 0.05F));
        const Vec3f place = random.in_box({{0, 0, 0.1F}, {1, 1, 0.3F}});
        for (Vec3f& vertex : sphere.vertices) {
            vertex = vertex + place;
        }
        mesh = joined(std::move(mesh), sphere);
    }
    return mesh;
}

INSTANTIATE_TEST_SUITE_P(Seeds1And2, GrownFromOnePercent,
                         testing::Values(NamedScene{"terrain", [] { return make_terrain(224, 1); }},
                                         NamedScene{"sphere", [] { return make_sphere(200, 250); }},
                                         NamedScene{"spheres_on_floor", make_spheres_on_floor}),
                         scene_name);

}  // namespace
}  // namespace coppice::test
