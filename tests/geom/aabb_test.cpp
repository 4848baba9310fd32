#include "coppice/geom/aabb.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace coppice::test {
namespace {

constexpr Aabb box{{1, 2, 3}, {2, 4, 8}};

TEST(Aabb, IsEmptyByDefault) {
    const Aabb empty;
    EXPECT_TRUE(empty.is_empty());
    EXPECT_EQ(empty.lower, (Vec3f{Aabb::infinity, Aabb::infinity, Aabb::infinity}));
    EXPECT_EQ(empty.upper, (Vec3f{-Aabb::infinity, -Aabb::infinity, -Aabb::infinity}));
    EXPECT_EQ(empty.surface_area(), 0.0);
    for (const Axis axis : all_axes) {
        EXPECT_EQ(empty.extent(axis), 0.0);
    }
    EXPECT_FALSE(empty.contains({0, 0, 0}));
    EXPECT_FALSE(empty.overlaps(box));
    EXPECT_FALSE(box.overlaps(empty));
    EXPECT_FALSE(empty.overlaps(empty));
}

TEST(Aabb, IsEmptyIfAnyAxisIs) {
    for (const Axis axis : all_axes) {
        Aabb inverted = box;
        std::swap(inverted.lower[axis], inverted.upper[axis]);
        EXPECT_TRUE(inverted.is_empty());
        EXPECT_EQ(inverted.extent(axis), 0.0);
        Aabb flat = box;
        flat.lower[axis] = flat.upper[axis];
        EXPECT_FALSE(flat.is_empty());
    }
}

TEST(Aabb, IsEmptyIfNotANumber) {
    for (const Axis axis : all_axes) {
        Aabb broken = box;
        broken.lower[axis] = std::numeric_limits<float>::quiet_NaN();
        EXPECT_TRUE(broken.is_empty());
    }
}

TEST(Aabb, KnowsItsSizes) {
    EXPECT_EQ(box.extent(Axis::x), 1.0);
    EXPECT_EQ(box.extent(Axis::y), 2.0);
    EXPECT_EQ(box.extent(Axis::z), 5.0);
    EXPECT_EQ(box.longest_axis(), Axis::z);
    EXPECT_EQ(box.surface_area(), 2.0 * (1 * 2 + 2 * 5 + 5 * 1));
    EXPECT_EQ((Aabb{{0, 0, 0}, {3, 0, 2}}).surface_area(), 12.0);
    EXPECT_EQ((Aabb{{0, 0, 0}, {3, 0, 0}}).surface_area(), 0.0);
}

TEST(Aabb, PrefersTheFirstOfEquallyLongAxes) {
    EXPECT_EQ((Aabb{{0, 0, 0}, {1, 1, 1}}).longest_axis(), Axis::x);
    EXPECT_EQ((Aabb{{0, 0, 0}, {1, 2, 2}}).longest_axis(), Axis::y);
    EXPECT_EQ((Aabb{{0, 0, 0}, {2, 1, 2}}).longest_axis(), Axis::x);
    EXPECT_EQ(Aabb{}.longest_axis(), Axis::x);
}

TEST(Aabb, DoesNotOverflowOrUnderflow) {
    constexpr float most = std::numeric_limits<float>::max();
    const Aabb utmost{{-most, -most, -most}, {most, most, most}};
    EXPECT_EQ(utmost.extent(Axis::x), 2.0 * static_cast<double>(most));
    EXPECT_GT(utmost.surface_area(), 1e78);
    EXPECT_LT(utmost.surface_area(), 1e79);
    const Aabb least{{0, 0, 0}, {1e-45F, 1e-45F, 1e-45F}};
    EXPECT_GT(least.surface_area(), 0.0);
}

TEST(Aabb, ContainsItsBoundary) {
    EXPECT_TRUE(box.contains({1, 2, 3}));
    EXPECT_TRUE(box.contains({2, 4, 8}));
    EXPECT_TRUE(box.contains({1.5F, 3, 4}));
    for (const Axis axis : all_axes) {
        Vec3f outside{1.5F, 3, 4};
        outside[axis] = std::nextafter(box.lower[axis], -Aabb::infinity);
        EXPECT_FALSE(box.contains(outside));
        outside[axis] = std::nextafter(box.upper[axis], Aabb::infinity);
        EXPECT_FALSE(box.contains(outside));
    }
    EXPECT_TRUE((Aabb{{0, 0, 0}, {0, 0, 0}}).contains({-0.0F, -0.0F, -0.0F}));
}

TEST(Aabb, OverlapsWhatItTouches) {
    EXPECT_TRUE(box.overlaps(box));
    for (const Axis axis : all_axes) {
        Aabb beside = box;
        beside.lower[axis] = box.upper[axis];
        beside.upper[axis] = box.upper[axis] + 1.0F;
        EXPECT_TRUE(box.overlaps(beside));
        EXPECT_TRUE(beside.overlaps(box));
        beside.lower[axis] = std::nextafter(box.upper[axis], Aabb::infinity);
        EXPECT_FALSE(box.overlaps(beside));
        EXPECT_FALSE(beside.overlaps(box));
    }
}

TEST(Aabb, Grows) {
    Aabb grown;
    grown.grow(Vec3f{1, 2, 3});
    EXPECT_EQ(grown, (Aabb{{1, 2, 3}, {1, 2, 3}}));
    grown.grow(Vec3f{0, 5, 3});
    EXPECT_EQ(grown, (Aabb{{0, 2, 3}, {1, 5, 3}}));
    grown.grow(box);
    EXPECT_EQ(grown, (Aabb{{0, 2, 3}, {2, 5, 8}}));
    grown.grow(Aabb{});
    EXPECT_EQ(grown, (Aabb{{0, 2, 3}, {2, 5, 8}}));
    Aabb from_empty;
    from_empty.grow(box);
    EXPECT_EQ(from_empty, box);
}

TEST(Aabb, IsCutByPlanes) {
    EXPECT_EQ(below(box, {Axis::y, 3}), (Aabb{{1, 2, 3}, {2, 3, 8}}));
    EXPECT_EQ(above(box, {Axis::y, 3}), (Aabb{{1, 3, 3}, {2, 4, 8}}));
    EXPECT_EQ(below(box, {Axis::x, 1}), (Aabb{{1, 2, 3}, {1, 4, 8}}));
}

TEST(Aabb, HasIntersections) {
    EXPECT_EQ(intersection(box, Aabb{}), Aabb{});
    EXPECT_EQ(intersection(box, box), box);
    EXPECT_EQ(intersection(box, {{0, 3, 4}, {1.5F, 9, 5}}), (Aabb{{1, 3, 4}, {1.5F, 4, 5}}));
    EXPECT_TRUE(intersection(box, {{3, 0, 0}, {4, 9, 9}}).is_empty());
    EXPECT_EQ(intersection(box, {{2, 4, 8}, {9, 9, 9}}), (Aabb{{2, 4, 8}, {2, 4, 8}}));
}

}  // namespace
}  // namespace coppice::test
