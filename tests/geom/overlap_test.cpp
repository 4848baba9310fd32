#include "coppice/geom/overlap.h"

#include "support/random.h"
#include "support/reference_clip.h"

#include <gtest/gtest.h>

namespace coppice::test {
namespace {

constexpr Aabb unit_cube{{0, 0, 0}, {1, 1, 1}};

TEST(TriangleOverlapsBox, WhereTheyTouch) {
    EXPECT_TRUE(overlaps({Vec3f{1, 1, 1}, Vec3f{2, 1, 1}, Vec3f{1, 2, 1}}, unit_cube)) << "corner";
    EXPECT_TRUE(overlaps({Vec3f{2, 0, 0.5F}, Vec3f{0, 2, 0.5F}, Vec3f{2, 2, 0}}, unit_cube))
        << "edge to edge";
    EXPECT_TRUE(overlaps({Vec3f{3, 0, 0}, Vec3f{0, 3, 0}, Vec3f{0, 0, 3}}, unit_cube))
        << "face to corner";
    EXPECT_TRUE(overlaps({Vec3f{-9, -9, 0.5F}, Vec3f{9, -9, 0.5F}, Vec3f{0, 9, 0.5F}}, unit_cube))
        << "through the middle";
    EXPECT_TRUE(overlaps({Vec3f{1, 0, 0}, Vec3f{1, 1, 0}, Vec3f{1, 0, 1}}, unit_cube)) << "planar";
}

TEST(TriangleOverlapsBox, NotWhereTheyJustDoNot) {
    EXPECT_FALSE(overlaps({Vec3f{3.000001F, 0, 0}, Vec3f{0, 3.000001F, 0}, Vec3f{0, 0, 3.000001F}},
                          unit_cube));
    EXPECT_FALSE(overlaps({Vec3f{2, 0.000001F, 0.5F}, Vec3f{0, 2.000001F, 0.5F}, Vec3f{2, 2, 0.5F}},
                          unit_cube));
    EXPECT_FALSE(overlaps({Vec3f{1.000001F, 0, 0}, Vec3f{2, 1, 0}, Vec3f{2, 0, 1}}, unit_cube));
    EXPECT_FALSE(overlaps({Vec3f{0, 0, 0}, Vec3f{1, 0, 0}, Vec3f{0, 1, 0}}, Aabb{}));
}

TEST(TriangleOverlapsBox, OfAnySize) {
    const Triangle t{Vec3f{0.25F, 0, 0}, Vec3f{0, 0.25F, 0}, Vec3f{0, 0, 0.25F}};
    EXPECT_TRUE(overlaps(t, {{0.125F, 0.125F, 0}, {0.125F, 0.125F, 0}})) << "a point";
    EXPECT_FALSE(overlaps(t, {{0.125F, 0.126F, 0}, {0.125F, 0.126F, 0}}));
    constexpr float infinity = Aabb::infinity;
    EXPECT_TRUE(overlaps(t, {{-infinity, -infinity, -infinity}, {infinity, 0, 0}}));
    EXPECT_FALSE(overlaps(t, {{-infinity, -infinity, -infinity}, {infinity, infinity, -1e-30F}}));
}

// Where clipping in extended precision leaves a part of some extent, or nothing by some margin.
TEST(TriangleOverlapsBox, AgreesWithClipping_Seed7) {
    Random random(7);
    const Aabb around{{-1, -1, -1}, {2, 2, 2}};
    int overlap_count = 0;
    for (int i = 0; i < 20'000; ++i) {
        const Triangle t{random.in_box(around), random.in_box(around), random.in_box(around)};
        const float scale = std::exp2(static_cast<float>(random.below(200)) - 100.0F);
        const Triangle scaled{scale * t[0], scale * t[1], scale * t[2]};
        const Aabb box{{}, {scale, scale, scale}};
        const bool is_inside =
            !reference_clip(t, to_bvh8(unit_cube).grown({-1e-9, -1e-9, -1e-9})).is_empty();
        const bool is_near =
            !reference_clip(t, to_bvh8(unit_cube).grown({1e-9, 1e-9, 1e-9})).is_empty();
        if (is_inside != is_near) continue;
        ASSERT_EQ(overlaps(scaled, box), is_inside) << i;
        overlap_count += is_inside ? 1 : 0;
    }
    EXPECT_GT(overlap_count, 1000);
}

}  // namespace
}  // namespace coppice::test
