#include "coppice/geom/triangle.h"
#include "coppice/geom/triangle_mesh.h"

#include "support/meshes.h"
#include "support/numbers.h"
#include "support/random.h"
#include "support/rays.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

namespace coppice::test {
namespace {

// In the plane z = 2, seen from the origin.
constexpr Triangle triangle{Vec3f{-1, -1, 2}, Vec3f{3, -1, 2}, Vec3f{-1, 3, 2}};
constexpr Ray upward{.origin = {0, 0, 0}, .direction = {0, 0, 1}};

TEST(IntersectTriangle, FindsDistanceAndBarycentrics) {
    const auto hit = intersect_triangle(upward, triangle);
    ASSERT_TRUE(hit.has_value());
    EXPECT_EQ(hit->t, 2.0F);
    EXPECT_EQ(hit->u, 0.25F);
    EXPECT_EQ(hit->v, 0.25F);
    EXPECT_EQ(hit->prim, 0U);
}

TEST(IntersectTriangle, HitsBothSides) {
    EXPECT_TRUE(intersect_triangle(upward, triangle).has_value());
    const Ray downward{.origin = {0, 0, 5}, .direction = {0, 0, -2}};
    const auto hit = intersect_triangle(downward, triangle);
    ASSERT_TRUE(hit.has_value());
    EXPECT_EQ(hit->t, 1.5F);
    const Triangle flipped{triangle[1], triangle[0], triangle[2]};
    const auto swapped = intersect_triangle(upward, flipped);
    ASSERT_TRUE(swapped.has_value());
    EXPECT_EQ(swapped->u, 0.5F);
    EXPECT_EQ(swapped->v, 0.25F);
}

TEST(IntersectTriangle, MeasuresInLengthsOfTheDirection) {
    for (const float length : {1e-20F, 0.5F, 1e20F}) {
        const auto hit = intersect_triangle({{0, 0, 0}, {0, 0, length}}, triangle);
        ASSERT_TRUE(hit.has_value());
        EXPECT_FLOAT_EQ(hit->t, 2.0F / length);
    }
}

TEST(IntersectTriangle, MissesOutside) {
    EXPECT_FALSE(intersect_triangle({{2, 2, 0}, {0, 0, 1}}, triangle).has_value());
    EXPECT_FALSE(intersect_triangle({{0, 0, 0}, {0, 0, -1}}, triangle).has_value());
    EXPECT_FALSE(intersect_triangle({{0, 0, 0}, {1, 0, 0}}, triangle).has_value());
}

TEST(IntersectTriangle, KeepsToTheRange) {
    const auto hits = [](float t_min, float t_max) {
        return intersect_triangle({{0, 0, 0}, {0, 0, 1}, t_min, t_max}, triangle).has_value();
    };
    EXPECT_TRUE(hits(2.0F, 2.0F));
    EXPECT_TRUE(hits(2.0F, infinity));
    EXPECT_TRUE(hits(0.0F, 2.0F));
    EXPECT_FALSE(hits(std::nextafter(2.0F, 3.0F), infinity));
    EXPECT_FALSE(hits(0.0F, std::nextafter(2.0F, 1.0F)));
    EXPECT_FALSE(hits(3.0F, 1.0F));
    EXPECT_FALSE(hits(nan, infinity));
    EXPECT_FALSE(hits(0.0F, nan));
}

TEST(IntersectTriangle, LooksBehindTheOriginIfAskedTo) {
    const Ray ray{{0, 0, 3}, {0, 0, 1}, -2.0F, 5.0F};
    const auto hit = intersect_triangle(ray, triangle);
    ASSERT_TRUE(hit.has_value());
    EXPECT_EQ(hit->t, -1.0F);
    EXPECT_FALSE(intersect_triangle({{0, 0, 3}, {0, 0, 1}, -2.0F, -0.5F}, triangle).has_value());
}

TEST(IntersectTriangle, HitsAtTheOrigin) {
    const auto hit = intersect_triangle({{0, 0, 2}, {0, 0.5F, 1}}, triangle);
    ASSERT_TRUE(hit.has_value());
    EXPECT_EQ(hit->t, 0.0F);
}

TEST(IntersectTriangle, MissesForBadRays) {
    for (const float bad : {nan, infinity, -infinity}) {
        for (const Axis axis : all_axes) {
            Ray ray = upward;
            ray.origin[axis] = bad;
            EXPECT_FALSE(intersect_triangle(ray, triangle).has_value());
            ray = upward;
            ray.direction[axis] = bad;
            EXPECT_FALSE(intersect_triangle(ray, triangle).has_value());
        }
    }
    EXPECT_FALSE(intersect_triangle({{0, 0, 2}, {0, 0, 0}}, triangle).has_value());
    EXPECT_FALSE(intersect_triangle({{0, 0, 2}, {-0.0F, 0, -0.0F}}, triangle).has_value());
}

TEST(IntersectTriangle, TreatsNegativeZeroAsZero) {
    for (const float x : {0.0F, -0.0F}) {
        for (const float y : {0.0F, -0.0F}) {
            const auto hit = intersect_triangle({{0, 0, 0}, {x, y, 1}}, triangle);
            ASSERT_TRUE(hit.has_value());
            EXPECT_EQ(hit->t, 2.0F);
        }
    }
}

TEST(IntersectTriangle, MissesEdgeOn) {
    EXPECT_FALSE(intersect_triangle({{-5, 0, 2}, {1, 0, 0}}, triangle).has_value());
    EXPECT_FALSE(intersect_triangle({{-5, -1, 2}, {1, 0, 0}}, triangle).has_value());
}

TEST(IntersectTriangle, MissesDegenerateTriangles) {
    const Vec3f p{0, 0, 2};
    EXPECT_FALSE(intersect_triangle(upward, {p, p, p}).has_value());
    EXPECT_FALSE(intersect_triangle(upward, {p, Vec3f{1, 1, 2}, Vec3f{2, 2, 2}}).has_value());
    EXPECT_FALSE(intersect_triangle(upward, {p, p, Vec3f{1, 0, 2}}).has_value());
}

TEST(IntersectTriangle, HitsEdgesAndCorners) {
    for (const Vec3f& corner : triangle) {
        EXPECT_TRUE(intersect_triangle({{corner.x, corner.y, 0}, {0, 0, 1}}, triangle).has_value());
        EXPECT_TRUE(intersect_triangle({{0, 0, 0}, corner}, triangle).has_value());
    }
    for (const Vec3f& middle : {Vec3f{1, -1, 2}, Vec3f{1, 1, 2}, Vec3f{-1, 1, 2}}) {
        EXPECT_TRUE(intersect_triangle({{middle.x, middle.y, 0}, {0, 0, 1}}, triangle).has_value());
    }
}

class IntersectRandomTriangle : public testing::TestWithParam<std::uint64_t> {};

TEST_P(IntersectRandomTriangle, BarycentricsReproduceThePoint) {
    Random random(GetParam());
    int hit_count = 0;
    for (int i = 0; i < 20'000; ++i) {
        const Aabb around{{-1, -1, -1}, {1, 1, 1}};
        const Triangle any{random.in_box(around), random.in_box(around), random.in_box(around)};
        const Ray ray =
            ray_through(random.in_box({{-3, -3, -3}, {3, 3, 3}}), random.in_box(around));
        const auto hit = intersect_triangle(ray, any);
        if (!hit) continue;
        ++hit_count;
        ASSERT_GE(hit->u, 0.0F);
        ASSERT_GE(hit->v, 0.0F);
        ASSERT_LE(hit->u + hit->v, 1.0F + 1e-6F);
        const Vec3d a = to_double(any[0]);
        const Vec3d on_triangle = a + static_cast<double>(hit->u) * (to_double(any[1]) - a) +
                                  static_cast<double>(hit->v) * (to_double(any[2]) - a);
        const Vec3d on_ray =
            to_double(ray.origin) + static_cast<double>(hit->t) * to_double(ray.direction);
        const double scale = 1.0 + hit->t * std::sqrt(dot(ray.direction, ray.direction));
        for (const Axis axis : all_axes) {
            ASSERT_NEAR(on_triangle[axis], on_ray[axis], 4e-7 * scale);
        }
    }
    EXPECT_GT(hit_count, 1000);
}

TEST_P(IntersectRandomTriangle, AgreesWithAnotherFormula) {
    // Cramer's rule (Moeller and Trumbore 1997) in double; where it is clear, both must agree.
    Random random(GetParam());
    const Aabb around{{-1, -1, -1}, {1, 1, 1}};
    for (int i = 0; i < 20'000; ++i) {
        const Triangle any{random.in_box(around), random.in_box(around), random.in_box(around)};
        const Ray ray = ray_through(random.in_box(around), random.in_box(around));
        const Vec3d a = to_double(any[0]);
        const Vec3d ab = to_double(any[1]) - a;
        const Vec3d ac = to_double(any[2]) - a;
        const Vec3d direction = to_double(ray.direction);
        const Vec3d from_a = to_double(ray.origin) - a;
        const double determinant = dot(ab, cross(direction, ac));
        if (std::abs(determinant) < 1e-6) continue;
        const double u = dot(from_a, cross(direction, ac)) / determinant;
        const double v = dot(direction, cross(from_a, ab)) / determinant;
        const double t = dot(ac, cross(from_a, ab)) / determinant;
        constexpr double clear = 1e-6;
        const double least = std::min({u, v, 1.0 - u - v, t});
        if (std::abs(least) < clear) continue;
        const auto hit = intersect_triangle(ray, any);
        ASSERT_EQ(hit.has_value(), least > 0.0);
        if (hit) {
            ASSERT_NEAR(hit->t, t, 1e-6 * (1.0 + t));
            ASSERT_NEAR(hit->u, u, 1e-6);
            ASSERT_NEAR(hit->v, v, 1e-6);
        }
    }
}

// Two triangles that share an edge, over a quadrilateral: a ray through the edge hits one.
TEST_P(IntersectRandomTriangle, SharedEdgesHaveNoGap) {
    Random random(GetParam());
    const Aabb around{{-1, -1, -1}, {1, 1, 1}};
    for (int i = 0; i < 50'000; ++i) {
        const double scale = std::exp2(static_cast<int>(random.below(120)) - 60.0);
        const Vec3f a = to_float(scale * to_double(random.in_box(around)));
        const Vec3f b = to_float(scale * to_double(random.in_box(around)));
        const Vec3f origin = to_float(scale * to_double(random.in_box(around)));
        const double s = random.below(2) == 0 ? 0.5 : random.unit();
        const Vec3f target = to_float(to_double(a) + s * (to_double(b) - to_double(a)));
        const Ray ray = ray_through(origin, target);
        // On both sides of the plane of the origin and the edge.
        const Vec3d across = cross(to_double(b) - to_double(a), to_double(origin) - to_double(a));
        const double length = std::sqrt(dot(across, across));
        if (!(length > 1e-4 * scale * scale)) continue;
        const Vec3d aside = (scale * (0.2 + random.unit()) / length) * across;
        const Vec3d middle = 0.5 * (to_double(a) + to_double(b));
        const Triangle left{a, b, to_float(middle + aside)};
        const Triangle right{b, a, to_float(middle - aside)};
        ASSERT_TRUE(intersect_triangle(ray, left) || intersect_triangle(ray, right))
            << "case " << i << ", scale " << scale;
    }
}

INSTANTIATE_TEST_SUITE_P(Seed, IntersectRandomTriangle, testing::Values(1U, 2U),
                         [](const auto& each) { return std::to_string(each.param); });

bool hits_any(TriangleMeshView mesh, const Ray& ray) {
    for (std::uint32_t id = 0; id < mesh.size(); ++id) {
        if (intersect_triangle(ray, mesh.triangle(id))) return true;
    }
    return false;
}

class IntersectClosedMesh : public testing::TestWithParam<std::uint64_t> {};

TEST_P(IntersectClosedMesh, HasNoGapSeenFromInside) {
    const TriangleMesh mesh = make_sphere(6, 8);
    Random random(GetParam());
    const Aabb inner{{-0.5F, -0.5F, -0.5F}, {0.5F, 0.5F, 0.5F}};
    for (int i = 0; i < 20'000; ++i) {
        const Vec3f from = i % 2 == 0 ? Vec3f{} : random.in_box(inner);
        const Triangle any = mesh.view().triangle(random.below(mesh.view().size()));
        const Vec3f middle = to_float(0.5 * (to_double(any[0]) + to_double(any[1])));
        for (const Vec3f& target : {any[2], middle, to_float(random.direction())}) {
            ASSERT_TRUE(hits_any(mesh.view(), ray_through(from, target))) << "ray " << i;
        }
    }
}

TEST_P(IntersectClosedMesh, HasNoGapAtGridEdges) {
    // A box around the origin with vertices where rays of small integer directions pass.
    const TriangleMesh mesh = [] {
        TriangleMesh sides;
        for (const float side : {-1.0F, 1.0F}) {
            sides =
                joined(std::move(sides), make_sheet(4, {side, -1, -1}, {0, 0.5F, 0}, {0, 0, 0.5F}));
            sides =
                joined(std::move(sides), make_sheet(4, {-1, side, -1}, {0.5F, 0, 0}, {0, 0, 0.5F}));
            sides =
                joined(std::move(sides), make_sheet(4, {-1, -1, side}, {0.5F, 0, 0}, {0, 0.5F, 0}));
        }
        return sides;
    }();
    Random random(GetParam());
    for (int i = 0; i < 5'000; ++i) {
        Ray ray;
        for (const Axis axis : all_axes) {
            ray.origin[axis] = 0.25F * (static_cast<float>(random.below(7)) - 3.0F);
            ray.direction[axis] = static_cast<float>(random.below(9)) - 4.0F;
            if (ray.direction[axis] == 0.0F && random.below(2) == 0) ray.direction[axis] = -0.0F;
        }
        if (!is_traceable(ray)) continue;
        ASSERT_TRUE(hits_any(mesh.view(), ray)) << "ray " << i;
    }
}

INSTANTIATE_TEST_SUITE_P(Seed, IntersectClosedMesh, testing::Values(1U, 2U),
                         [](const auto& each) { return std::to_string(each.param); });

TEST(IntersectTriangle, WorksAtAllScales) {
    for (const float scale : {1e-38F, 1e-30F, 1e-10F, 1.0F, 1e10F, 1e30F, 1e38F}) {
        Triangle large = triangle;
        for (Vec3f& corner : large) {
            corner = scale * corner;
        }
        const auto hit = intersect_triangle({{0, 0, 0}, {0, 0, scale}}, large);
        ASSERT_TRUE(hit.has_value()) << scale;
        EXPECT_FLOAT_EQ(hit->t, 2.0F);
        EXPECT_FLOAT_EQ(hit->u, 0.25F);
    }
}

TEST(IntersectTriangle, WorksFarFromTheOrigin) {
    // 1e6 away from a triangle of size 1, slanted.
    const Triangle far{Vec3f{1e6F, 0, 0}, Vec3f{1e6F, 1, 0}, Vec3f{1e6F, 0, 1}};
    const auto hit = intersect_triangle({{0, 0, 0}, {1e6F, 0.25F, 0.5F}}, far);
    ASSERT_TRUE(hit.has_value());
    EXPECT_EQ(hit->t, 1.0F);
    EXPECT_FLOAT_EQ(hit->u, 0.25F);
    EXPECT_FLOAT_EQ(hit->v, 0.5F);
}

}  // namespace
}  // namespace coppice::test
