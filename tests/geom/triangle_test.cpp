#include "coppice/geom/triangle.h"

#include "support/random.h"
#include "support/reference_clip.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <string>
#include <tuple>

namespace coppice::test {
namespace {

constexpr Aabb unit_cube{{0, 0, 0}, {1, 1, 1}};

void PrintBox(std::ostream& stream, const Aabb& box) {  // NOLINT(readability-identifier-naming)
    stream.precision(9);
    stream << std::hexfloat;
    for (const Axis axis : all_axes) {
        stream << " [" << box.lower[axis] << ", " << box.upper[axis] << "]";
    }
}

std::string description(const Triangle& triangle, const Aabb& box, const Aabb& clipped) {
    std::ostringstream text;
    text << std::hexfloat << "triangle";
    for (const Vec3f& p : triangle) {
        text << " {" << p.x << ", " << p.y << ", " << p.z << "}";
    }
    text << "\nbox";
    PrintBox(text, box);
    text << "\nclipped";
    PrintBox(text, clipped);
    return text.str();
}

bool is_within(const Aabb& inner, const Aabb& outer) {
    return intersection(inner, outer) == inner;
}

TEST(TriangleBounds, HoldsTheCorners) {
    EXPECT_EQ(triangle_bounds({Vec3f{1, 5, 9}, Vec3f{2, 4, 7}, Vec3f{0, 6, 8}}),
              (Aabb{{0, 4, 7}, {2, 6, 9}}));
}

TEST(TriangleArea, IsThatOfTheTriangle) {
    EXPECT_EQ(triangle_area({Vec3f{0, 0, 0}, Vec3f{3, 0, 0}, Vec3f{0, 4, 0}}), 6.0);
    EXPECT_EQ(triangle_area({Vec3f{1, 1, 1}, Vec3f{1, 1, 1}, Vec3f{5, 5, 5}}), 0.0);
    EXPECT_NEAR(triangle_area({Vec3f{1e30F, 1e30F, 0}, Vec3f{1, 0, 0}, Vec3f{0, 1, 0}}), 1e30,
                1e24);
    EXPECT_EQ(triangle_area({Vec3f{0, 0, 0}, Vec3f{1, 1, 1}, Vec3f{3, 3, 3}}), 0.0);
    EXPECT_NEAR(triangle_area({Vec3f{0, 0, 0}, Vec3f{1e30F, 0, 0}, Vec3f{0, 1e30F, 0}}), 5e59,
                1e53);
    EXPECT_NEAR(triangle_area({Vec3f{0, 0, 0}, Vec3f{1e-30F, 0, 0}, Vec3f{0, 1e-30F, 0}}), 5e-61,
                1e-67);
}

TEST(ClippedTriangleBounds, IsTheBoundsOfATriangleInside) {
    const Triangle triangle{Vec3f{0, 0.5F, 1}, Vec3f{0.25F, 1, 0}, Vec3f{0.75F, 0.1F, 0.3F}};
    EXPECT_EQ(clipped_triangle_bounds(triangle, unit_cube), triangle_bounds(triangle));
    EXPECT_EQ(clipped_triangle_bounds(triangle, triangle_bounds(triangle)),
              triangle_bounds(triangle));
}

TEST(ClippedTriangleBounds, CutsAtThePlanes) {
    // The part of this triangle with x <= 1 ends at y = 1, by eye.
    const Triangle triangle{Vec3f{0, 0, 0}, Vec3f{2, 0, 0}, Vec3f{0, 2, 2}};
    const Aabb clipped = clipped_triangle_bounds(triangle, {{1, -9, -9}, {9, 9, 9}});
    EXPECT_EQ(clipped.lower, (Vec3f{1, 0, 0}));
    EXPECT_EQ(clipped.upper.x, 2.0F);
    EXPECT_FLOAT_EQ(clipped.upper.y, 1.0F);
    EXPECT_FLOAT_EQ(clipped.upper.z, 1.0F);
    EXPECT_GE(clipped.upper.y, 1.0F);
    EXPECT_GE(clipped.upper.z, 1.0F);
}

TEST(ClippedTriangleBounds, IsEmptyWhereBoxesAreApart) {
    const Triangle triangle{Vec3f{2, 0, 0}, Vec3f{3, 1, 0}, Vec3f{2, 1, 1}};
    EXPECT_EQ(clipped_triangle_bounds(triangle, unit_cube), Aabb{});
    EXPECT_EQ(clipped_triangle_bounds(triangle, Aabb{}), Aabb{});
}

TEST(ClippedTriangleBounds, IsEmptyWhereOnlyTheBoxesMeet) {
    // Passes the cube's corner (1, 1, 1) at a distance; the boxes overlap in an eighth.
    const Triangle diagonal{Vec3f{3, 0.5F, 0.5F}, Vec3f{0.5F, 3, 0.5F}, Vec3f{0.5F, 0.5F, 3}};
    EXPECT_TRUE(clipped_triangle_bounds(diagonal, unit_cube).is_empty());
    const Triangle edge{Vec3f{2, 0.5F, 0.5F}, Vec3f{0.5F, 2, 0.5F}, Vec3f{2, 2, 0.5F}};
    EXPECT_TRUE(clipped_triangle_bounds(edge, unit_cube).is_empty());
}

TEST(ClippedTriangleBounds, KeepsWhatOnlyTouches) {
    const Triangle at_face{Vec3f{1, 0.2F, 0.2F}, Vec3f{2, 0.2F, 0.2F}, Vec3f{2, 0.8F, 0.2F}};
    EXPECT_FALSE(clipped_triangle_bounds(at_face, unit_cube).is_empty());
    EXPECT_EQ(clipped_triangle_bounds(at_face, unit_cube).lower.x, 1.0F);
    EXPECT_EQ(clipped_triangle_bounds(at_face, unit_cube).upper.x, 1.0F);
    const Triangle at_corner{Vec3f{1, 1, 1}, Vec3f{2, 1, 1}, Vec3f{1, 2, 1}};
    EXPECT_EQ(clipped_triangle_bounds(at_corner, unit_cube), (Aabb{{1, 1, 1}, {1, 1, 1}}));
    // An edge that passes through the corner, exactly.
    const Triangle across_corner{Vec3f{2, 0, 1}, Vec3f{0, 2, 1}, Vec3f{2, 2, 1}};
    EXPECT_FALSE(clipped_triangle_bounds(across_corner, unit_cube).is_empty());
}

TEST(ClippedTriangleBounds, StaysFlat) {
    for (const Axis axis : all_axes) {
        for (const float position : {0.0F, -0.0F, 0.1F, 1e-30F, 1.0F}) {
            Triangle triangle{Vec3f{-1, -2, -3}, Vec3f{3, -1, -1}, Vec3f{1, 4, 5}};
            for (Vec3f& corner : triangle) {
                corner[axis] = position;
            }
            const Aabb clipped = clipped_triangle_bounds(triangle, unit_cube);
            ASSERT_FALSE(clipped.is_empty());
            EXPECT_EQ(clipped.lower[axis], position);
            EXPECT_EQ(clipped.upper[axis], position);
        }
    }
}

// Triangles that are hard to clip in one way or another.
enum class Shape { any, large, sliver, line, point, flat, on_faces, grid, mixed_scales };

struct Case {
    Triangle triangle;
    Aabb box;
};

float on_grid(Random& random) {
    return 0.25F * static_cast<float>(random.below(9)) - 0.5F;
}

Triangle make_triangle_of(Shape shape, Random& random) {
    const Aabb around{{-1, -1, -1}, {2, 2, 2}};
    Triangle triangle;
    for (Vec3f& corner : triangle) {
        corner = random.in_box(around);
    }
    auto& [a, b, c] = triangle;
    switch (shape) {
        case Shape::any:
            break;
        case Shape::large:
            for (Vec3f& corner : triangle) {
                corner = 1e4F * corner;
            }
            break;
        case Shape::sliver:
            c = b + random.uniform(0, 1e-6F) * to_float(random.direction());
            break;
        case Shape::line:
            c = 0.5F * (a + b);
            break;
        case Shape::point:
            b = c = a;
            break;
        case Shape::flat: {
            const auto axis = static_cast<Axis>(random.below(3));
            a[axis] = b[axis] = c[axis] = random.uniform(0, 1);
            break;
        }
        case Shape::on_faces:
            for (Vec3f& corner : triangle) {
                corner[static_cast<Axis>(random.below(3))] = random.below(2) == 0 ? 0.0F : 1.0F;
            }
            break;
        case Shape::grid:
            for (Vec3f& corner : triangle) {
                for (const Axis axis : all_axes) {
                    corner[axis] = on_grid(random);
                }
            }
            break;
        case Shape::mixed_scales:
            for (Vec3f& corner : triangle) {
                for (const Axis axis : all_axes) {
                    corner[axis] *= std::exp2(static_cast<float>(random.below(60)) - 30.0F);
                }
            }
            break;
    }
    return triangle;
}

Aabb make_box_for(Shape shape, Random& random) {
    if (shape == Shape::on_faces || random.below(4) == 0) return unit_cube;
    Aabb box;
    box.grow(random.in_box({{-1, -1, -1}, {2, 2, 2}}));
    box.grow(random.in_box({{-1, -1, -1}, {2, 2, 2}}));
    if (shape == Shape::grid) {
        for (const Axis axis : all_axes) {
            const float first = on_grid(random);
            const float second = on_grid(random);
            box.lower[axis] = std::min(first, second);
            box.upper[axis] = std::max(first, second);
        }
    }
    if (random.below(8) == 0) {  // a thin or flat box
        const auto axis = static_cast<Axis>(random.below(3));
        box.upper[axis] = random.below(2) == 0 ? std::nextafter(box.lower[axis], Aabb::infinity)
                                               : box.lower[axis];
    }
    return box;
}

// Scales a case by a power of two, which changes no digit.
Case make_case(Shape shape, int exponent, Random& random) {
    Case made{make_triangle_of(shape, random), make_box_for(shape, random)};
    const float factor = std::ldexp(1.0F, exponent);
    for (Vec3f& corner : made.triangle) {
        corner = factor * corner;
    }
    made.box.lower = factor * made.box.lower;
    made.box.upper = factor * made.box.upper;
    return made;
}

Vec3<long double> largest_coordinates(const Triangle& triangle) {
    Vec3<long double> largest;
    for (const Vec3f& corner : triangle) {
        for (const Axis axis : all_axes) {
            largest[axis] = std::max<long double>(largest[axis], std::abs(corner[axis]));
        }
    }
    return largest;
}

using ShapeAndSeed = std::tuple<Shape, int, std::uint64_t>;

class ClippedTriangleBoundsOf : public testing::TestWithParam<ShapeAndSeed> {
protected:
    template <typename Check>
    static void for_all_cases(int count, Check&& check) {
        const auto [shape, exponent, seed] = GetParam();
        Random random(seed);
        for (int i = 0; i < count && !HasFailure(); ++i) {
            const auto [triangle, box] = make_case(shape, exponent, random);
            const Aabb clipped = clipped_triangle_bounds(triangle, box);
            SCOPED_TRACE(description(triangle, box, clipped));
            check(triangle, box, clipped, random);
        }
    }
};

constexpr int case_count = 4000;

TEST_P(ClippedTriangleBoundsOf, IsWithinTriangleAndBox) {
    for_all_cases(case_count,
                  [](const Triangle& triangle, const Aabb& box, const Aabb& clipped, Random&) {
                      if (clipped.is_empty()) return;
                      EXPECT_TRUE(is_within(clipped, box));
                      EXPECT_TRUE(is_within(clipped, triangle_bounds(triangle)));
                  });
}

TEST_P(ClippedTriangleBoundsOf, HoldsTheExactPart) {
    for_all_cases(case_count,
                  [](const Triangle& triangle, const Aabb& box, const Aabb& clipped, Random&) {
                      const Bvh8Box exact = reference_clip(triangle, to_bvh8(box));
                      if (exact.is_empty()) return;
                      ASSERT_FALSE(clipped.is_empty());
                      const auto noise = 0x1p-58L * largest_coordinates(triangle);
                      for (const Axis axis : all_axes) {
                          EXPECT_LE(clipped.lower[axis], exact.lower[axis] + noise[axis]);
                          EXPECT_GE(clipped.upper[axis], exact.upper[axis] - noise[axis]);
                      }
                  });
}

TEST_P(ClippedTriangleBoundsOf, IsHardlyLargerThanThePartInABoxHardlyLarger) {
    for_all_cases(case_count, [](const Triangle& triangle, const Aabb& box, const Aabb& clipped,
                                 Random&) {
        if (clipped.is_empty()) return;
        const auto margin = 0x1p-44L * largest_coordinates(triangle);
        const Bvh8Box exact = reference_clip(triangle, to_bvh8(box).grown(margin)).grown(margin);
        ASSERT_FALSE(exact.is_empty());
        for (const Axis axis : all_axes) {
            EXPECT_GE(std::nextafter(clipped.lower[axis], Aabb::infinity), exact.lower[axis]);
            EXPECT_LE(std::nextafter(clipped.upper[axis], -Aabb::infinity), exact.upper[axis]);
        }
    });
}

TEST_P(ClippedTriangleBoundsOf, HoldsAllPointsOfTheTriangleInTheBox) {
    for_all_cases(case_count / 10, [](const Triangle& triangle, const Aabb& box,
                                      const Aabb& clipped, Random& random) {
        const auto noise = 0x1p-50L * largest_coordinates(triangle);
        for (int k = 0; k < 100; ++k) {
            double u = random.unit();
            double v = k < 20 ? 0.0 : random.unit();
            if (u + v > 1.0) {
                u = 1.0 - u;
                v = 1.0 - v;
            }
            const Vec3d a = to_double(triangle[0]);
            const Vec3d p = a + u * (to_double(triangle[1]) - a) + v * (to_double(triangle[2]) - a);
            bool is_inside_box = true;
            for (const Axis axis : all_axes) {
                is_inside_box =
                    is_inside_box && p[axis] >= box.lower[axis] && p[axis] <= box.upper[axis];
            }
            if (!is_inside_box) continue;
            for (const Axis axis : all_axes) {
                EXPECT_GE(p[axis], clipped.lower[axis] - noise[axis]);
                EXPECT_LE(p[axis], clipped.upper[axis] + noise[axis]);
            }
        }
    });
}

TEST_P(ClippedTriangleBoundsOf, ShrinksWithTheBox) {
    // Rounding may differ between the two ways, so an ulp is granted.
    const auto is_almost_within = [](const Aabb& inner, Aabb outer) {
        for (const Axis axis : all_axes) {
            outer.lower[axis] = std::nextafter(outer.lower[axis], -Aabb::infinity);
            outer.upper[axis] = std::nextafter(outer.upper[axis], Aabb::infinity);
        }
        return inner.is_empty() || is_within(inner, outer);
    };
    for_all_cases(case_count, [&](const Triangle& triangle, const Aabb& box, const Aabb& clipped,
                                  Random& random) {
        Aabb part = box;
        const auto axis = static_cast<Axis>(random.below(3));
        part.upper[axis] = random.uniform(box.lower[axis], box.upper[axis]);
        const Aabb clipped_part = clipped_triangle_bounds(triangle, part);
        EXPECT_TRUE(is_almost_within(clipped_part, clipped))
            << description(triangle, part, clipped_part);
        // As builders do: clip the part of what was left.
        const Aabb clipped_again = clipped_triangle_bounds(triangle, intersection(clipped, part));
        EXPECT_TRUE(clipped_again.is_empty() || is_within(clipped_again, clipped));
    });
}

TEST_P(ClippedTriangleBoundsOf, LosesNothingAtAPlane) {
    // Both halves together hold all that the whole held: no triangle falls between two cells.
    for_all_cases(case_count, [](const Triangle& triangle, const Aabb& box, const Aabb& clipped,
                                 Random& random) {
        if (reference_clip(triangle, to_bvh8(box)).is_empty()) return;
        const auto axis = static_cast<Axis>(random.below(3));
        const SplitPlane plane{axis, random.uniform(clipped.lower[axis], clipped.upper[axis])};
        const Aabb lower = clipped_triangle_bounds(triangle, below(clipped, plane));
        const Aabb upper = clipped_triangle_bounds(triangle, above(clipped, plane));
        EXPECT_FALSE(lower.is_empty() && upper.is_empty());
    });
}

std::string shape_name(const testing::TestParamInfo<ShapeAndSeed>& info) {
    constexpr std::array names{"any",  "large",   "sliver", "line",       "point",
                               "flat", "onfaces", "grid",   "mixedscales"};
    const auto [shape, exponent, seed] = info.param;
    const std::string sign = exponent < 0 ? "m" : "";
    return std::string(names.at(static_cast<std::size_t>(shape))) + "_2to" + sign +
           std::to_string(std::abs(exponent)) + "_" + std::to_string(seed);
}

INSTANTIATE_TEST_SUITE_P(All, ClippedTriangleBoundsOf,
                         testing::Combine(testing::Values(Shape::any, Shape::large, Shape::sliver,
                                                          Shape::line, Shape::point, Shape::flat,
                                                          Shape::on_faces, Shape::grid,
                                                          Shape::mixed_scales),
                                          testing::Values(0, 90, -110), testing::Values(1U)),
                         shape_name);

}  // namespace
}  // namespace coppice::test
