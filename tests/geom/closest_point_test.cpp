#include "coppice/geom/closest_point.h"

#include "support/random.h"

#include <gtest/gtest.h>

namespace coppice::test {
namespace {

constexpr Triangle flat{Vec3f{0, 0, 0}, Vec3f{4, 0, 0}, Vec3f{0, 4, 0}};

TEST(ClosestPoint, KnowsFaceEdgesAndCorners) {
    const auto expect = [](Vec3f from, Vec3f to, TriangleFeature feature) {
        const ClosestPoint found = closest_point(flat, from);
        EXPECT_EQ(found.point, to);
        EXPECT_EQ(found.feature, feature);
        const Vec3d between = to_double(from) - to_double(to);
        EXPECT_DOUBLE_EQ(found.distance_squared, dot(between, between));
        EXPECT_FLOAT_EQ(found.u, to.x / 4);
        EXPECT_FLOAT_EQ(found.v, to.y / 4);
    };
    expect({1, 1, -3}, {1, 1, 0}, TriangleFeature::face);
    expect({1, 1, 0}, {1, 1, 0}, TriangleFeature::face);
    expect({2, -1, 5}, {2, 0, 0}, TriangleFeature::edge_0);
    expect({3, 3, 1}, {2, 2, 0}, TriangleFeature::edge_1);
    expect({-1, 3, 1}, {0, 3, 0}, TriangleFeature::edge_2);
    expect({1, 0, 7}, {1, 0, 0}, TriangleFeature::edge_0);
    expect({-1, -2, 1}, {0, 0, 0}, TriangleFeature::corner_0);
    expect({6, 1, 1}, {4, 0, 0}, TriangleFeature::corner_1);
    expect({0, 4, 0}, {0, 4, 0}, TriangleFeature::corner_2);
}

TEST(ClosestPoint, OfDegenerateTrianglesIsOfTheirSegmentOrPoint) {
    const Vec3f p{1, 2, 3};
    EXPECT_EQ(closest_point({p, p, p}, {1, 2, 5}).distance_squared, 4.0);
    const Triangle segment{Vec3f{-1, 0, 0}, Vec3f{3, 0, 0}, Vec3f{1, 0, 0}};
    EXPECT_EQ(closest_point(segment, {2, 2, 0}).distance_squared, 4.0);
    EXPECT_EQ(closest_point(segment, {5, 0, 0}).distance_squared, 4.0);
}

// Sees both triangles of an edge from points over it, and from beside its ends.
TEST(ClosestPoint, IsEquallyFarFromBothTrianglesOfAnEdge_Seed5) {
    Random random(5);
    const Aabb cube{{-1, -1, -1}, {1, 1, 1}};
    for (int i = 0; i < 20'000; ++i) {
        const Vec3f a = random.in_box(cube);
        const Vec3f b = random.in_box(cube);
        const Vec3d along = to_double(b) - to_double(a);
        const Vec3d side = cross(along, random.direction());
        const Vec3d up = cross(along, side);
        const double share = random.unit();
        const auto wing = [&](double sign) {
            return to_float(to_double(a) + random.unit() * along + sign * side +
                            (-0.5 * random.unit()) * up);
        };
        const Vec3f left = wing(1.0);
        const Vec3f right = wing(-1.0);
        const Vec3f over = to_float(to_double(a) + share * along + random.unit() * up);
        const ClosestPoint first = closest_point({a, b, left}, over);
        const ClosestPoint second = closest_point({right, b, a}, over);
        if (first.feature != TriangleFeature::edge_0) continue;
        if (second.feature != TriangleFeature::edge_1) continue;
        ASSERT_EQ(first.distance_squared, second.distance_squared) << i;
    }
}

// A grid over the triangle finds nothing closer.
TEST(ClosestPoint, IsClosest_Seed6) {
    Random random(6);
    const Aabb cube{{-1, -1, -1}, {1, 1, 1}};
    for (int i = 0; i < 1000; ++i) {
        const Triangle t{random.in_box(cube), random.in_box(cube), random.in_box(cube)};
        const Vec3f from = random.in_box(cube);
        const ClosestPoint found = closest_point(t, from);
        const auto at = [&](double u, double v) {
            return (1.0 - u - v) * to_double(t[0]) + (u * to_double(t[1]) + v * to_double(t[2]));
        };
        const Vec3d off = at(found.u, found.v) - to_double(found.point);
        EXPECT_LT(dot(off, off), 1e-12);
        for (int u = 0; u <= 16; ++u) {
            for (int v = 0; u + v <= 16; ++v) {
                const Vec3d to = at(u / 16.0, v / 16.0) - to_double(from);
                ASSERT_LE(found.distance_squared, dot(to, to) + 1e-12);
            }
        }
    }
}

}  // namespace
}  // namespace coppice::test
