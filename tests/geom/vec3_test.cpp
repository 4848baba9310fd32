#include "coppice/geom/vec3.h"

#include <gtest/gtest.h>

namespace coppice::test {
namespace {

static_assert(sizeof(Vec3f) == 12, "vertex arrays are read and written as they are");
static_assert(next_axis(Axis::x) == Axis::y);
static_assert(next_axis(Axis::y) == Axis::z);
static_assert(next_axis(Axis::z) == Axis::x);

TEST(Vec3, IsIndexedByAxis) {
    Vec3f v{1, 2, 3};
    EXPECT_EQ(v[Axis::x], 1.0F);
    EXPECT_EQ(v[Axis::y], 2.0F);
    EXPECT_EQ(v[Axis::z], 3.0F);
    v[Axis::y] = 7.0F;
    EXPECT_EQ(v, (Vec3f{1, 7, 3}));
    v[Axis::x] = -1.0F;
    v[Axis::z] = 9.0F;
    EXPECT_EQ(v, (Vec3f{-1, 7, 9}));
}

TEST(Vec3, IsZeroByDefault) {
    EXPECT_EQ(Vec3f{}, (Vec3f{0, 0, 0}));
    EXPECT_EQ(Vec3f{}, (Vec3f{-0.0F, 0, -0.0F}));
}

TEST(Vec3, HasTheUsualArithmetic) {
    constexpr Vec3d a{1, 2, 3};
    constexpr Vec3d b{-4, 5, 0.5};
    EXPECT_EQ(a + b, (Vec3d{-3, 7, 3.5}));
    EXPECT_EQ(a - b, (Vec3d{5, -3, 2.5}));
    EXPECT_EQ(2.0 * a, (Vec3d{2, 4, 6}));
    EXPECT_EQ(dot(a, b), 7.5);
    EXPECT_EQ(cross(a, b), (Vec3d{-14, -12.5, 13}));
    EXPECT_EQ(dot(a, cross(a, b)), 0.0);
    EXPECT_EQ(cross(Vec3d{1, 0, 0}, Vec3d{0, 1, 0}), (Vec3d{0, 0, 1}));
}

TEST(Vec3, ConvertsToDoubleExactly) {
    EXPECT_EQ(to_double(Vec3f{0.1F, 1e-45F, 3e38F}), (Vec3d{0.1F, 1e-45F, 3e38F}));
}

}  // namespace
}  // namespace coppice::test
