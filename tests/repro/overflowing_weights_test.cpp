// In the sieve of the 8-wide traversals products of coordinates from 2^64 on overflowed where the
// bound on their errors did not: with fused multiplications (AVX2) weights became infinite, with a
// sign, and the triangle was missed for sure. Found by fuzzing.

#include "coppice/builders/build_tree.h"
#include "coppice/trace/brute_force.h"
#include "coppice/trace/bvh8_tracer.h"

#include "support/effort.h"
#include "support/meshes.h"
#include "support/random.h"

#include <gtest/gtest.h>

namespace coppice::test {
namespace {

TEST(OverflowingWeights, DoNotHideAHit) {
    const TriangleMesh mesh = make_triangle({Vec3f{-0x1.34p+3F, 0x1.b60eb4p-29F, 0x1.32159p+74F},
                                             {0x1.38p+2F, -0x1.33ec8ap-123F, -0x1.173ea8p-62F},
                                             {0x1.2cp+3F, 0x1.ep+0F, -0x1.fp+2F}});
    const Ray ray{{-0x1.3p+1F, 0x1.b60eb4p-30F, 0x1.32159p+73F},
                  {-0x1.2p+1F, 0x1.ap+0F, 0x1.98p+2F}};
    const auto expected = brute_force_intersect(mesh.view(), ray);
    ASSERT_TRUE(expected.has_value());
    for (const Isa isa : available_isas()) {
        EXPECT_EQ(Bvh8Tracer(build_bvh8(mesh.view()).tree, isa).intersect(ray), expected);
    }
}

TEST(OverflowingWeights, OfAnySizeAreHitAsByBruteForce) {
    Random random(7);
    for (float size = 1.0F; size < 0x1.0p120F; size *= 4.0F) {
        const TriangleMesh mesh = scaled(make_soup(20, 0.5F, 3), size);
        const Bvh8 tree = build_bvh8(mesh.view()).tree;
        for (int i = 0; i < effort(200); ++i) {
            const Vec3f origin = random.in_box(tree.bounds());
            const Vec3f target = mesh.view().triangle(random.below(20))[random.below(3)];
            const Ray ray{origin, (1.0F / size) * (target - origin)};
            const auto expected = brute_force_intersect(mesh.view(), ray);
            for (const Isa isa : available_isas()) {
                ASSERT_EQ(Bvh8Tracer(tree, isa).intersect(ray), expected) << size;
                ASSERT_EQ(Bvh8Tracer(tree, isa).occluded(ray), expected.has_value()) << size;
            }
        }
    }
}

}  // namespace
}  // namespace coppice::test
