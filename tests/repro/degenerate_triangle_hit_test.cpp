// A ray in one plane with a triangle of no area saw weights made of rounding errors and zeros, took
// them for a hit, and found it anywhere: here at t = 0, far from both the ray and the line.

#include "coppice/geom/triangle.h"

#include <gtest/gtest.h>

namespace coppice::test {
namespace {

TEST(DegenerateTriangleHit, NeedsTheRayToPassThroughIt) {
    // The line through the corners meets the ray at the origin, which is outside of the triangle.
    const Triangle degenerate{Vec3f{2, 0, 2}, Vec3f{3, 0, 3}, Vec3f{5, 0, 5}};
    const Ray ray{.origin = {0, 1, 3}, .direction = {0, -1, -3}};
    EXPECT_FALSE(intersect_triangle(ray, degenerate).has_value());
}

TEST(DegenerateTriangleHit, IsAtTheRightDistanceIfThereIsOne) {
    // Slivers through the origin, along many lines, seen from many places.
    for (int i = 0; i < 4000; ++i) {
        const auto number = [&](int divisor) { return static_cast<float>(i / divisor % 7 - 3); };
        const Vec3f along{number(1), number(7), 1};
        const Vec3f from{number(49), 2, number(343)};
        const Ray ray{.origin = from, .direction = -1.0F * from};
        const auto hit = intersect_triangle(ray, {-1.0F * along, 2.0F * along, 3.0F * along});
        const Vec3f normal = cross(along, from);
        if (normal == Vec3f{}) continue;  // along the line: anywhere on it will do
        EXPECT_TRUE(!hit || hit->t == 1.0F) << i;
    }
}

// Measured from a corner at 1e38 the distance came out as -0. Found by fuzzing; the distance is
// that of rational arithmetic.
TEST(DegenerateTriangleHit, IsAtTheRightDistanceWithACornerFarAway) {
    const Triangle triangle{Vec3f{-0x1.a8p+2F, -0x1.2ced32p+126F, -0x1.2ced32p+126F},
                            {-0x1.701e1cp+22F, 0x1.ep+0F, 0x1.ap+0F},
                            {0x1p-1F, 0x1.cp-1F, -0x1.ap+1F}};
    const Ray ray{{0.5F, 24.9375F, -31.0625F}, {-223424.0F, -34.8125F, 29.5625F}};
    const auto hit = intersect_triangle(ray, triangle);
    ASSERT_TRUE(hit.has_value());
    EXPECT_NEAR(hit->t, 0.807626132, 1e-6);
}

}  // namespace
}  // namespace coppice::test
