#include "scenes/hard_rays.h"

#include "scenes/procedural.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace coppice::lab {

namespace {

using MakeRays = std::vector<Ray> (*)(TriangleMeshView, std::size_t, std::uint64_t);

class HardRays : public testing::TestWithParam<MakeRays> {};

TEST_P(HardRays, AreTraceableAndDependOnTheSeedAlone) {
    const TriangleMesh mesh = make_procedural("city", 500, 1);
    const std::vector<Ray> rays = GetParam()(mesh.view(), 100, 3);
    ASSERT_EQ(rays.size(), 100U);
    EXPECT_TRUE(std::all_of(rays.begin(), rays.end(), is_traceable));
    const auto is_same = [](const Ray& a, const Ray& b) {
        return a.origin == b.origin && a.direction == b.direction;
    };
    const std::vector<Ray> fewer = GetParam()(mesh.view(), 50, 3);
    EXPECT_TRUE(std::equal(fewer.begin(), fewer.end(), rays.begin(), is_same));
    EXPECT_FALSE(is_same(GetParam()(mesh.view(), 1, 4)[0], rays[0]));
    EXPECT_TRUE(GetParam()({}, 100, 3).empty());
}

INSTANTIATE_TEST_SUITE_P(All, HardRays, testing::Values(random_rays, axis_rays, grazing_rays));

TEST(RandomRays, StartOutsideAndPassThroughTheBox) {
    const TriangleMesh mesh = make_procedural("spheres", 300, 1);
    const Aabb box = bounds_of(mesh.vertices);
    for (const Ray& ray : random_rays(mesh.view(), 1000, 1)) {
        EXPECT_FALSE(box.contains(ray.origin));
        double enter = 0.0;
        double exit = 1e30;
        for (const Axis axis : all_axes) {
            const double a = (box.lower[axis] - ray.origin[axis]) / ray.direction[axis];
            const double b = (box.upper[axis] - ray.origin[axis]) / ray.direction[axis];
            enter = std::max(enter, std::min(a, b));
            exit = std::min(exit, std::max(a, b));
        }
        EXPECT_LT(enter, exit + 1e-4);
    }
}

TEST(AxisRays, PassThroughVerticesAlongAnAxis) {
    const TriangleMesh mesh = make_procedural("city", 300, 1);
    const Aabb box = bounds_of(mesh.vertices);
    bool has_negative_zero = false;
    for (const Ray& ray : axis_rays(mesh.view(), 200, 1)) {
        Vec3f zeros = ray.direction;
        const auto is_along = [&](Axis axis) { return std::abs(ray.direction[axis]) == 1.0F; };
        const Axis along = *std::find_if(all_axes.begin(), all_axes.end(), is_along);
        zeros[along] = 0.0F;
        EXPECT_EQ(zeros, Vec3f{});
        const Axis other = next_axis(along);
        has_negative_zero |= std::signbit(ray.direction[other]);
        EXPECT_FALSE(box.contains(ray.origin));
        EXPECT_TRUE(std::any_of(mesh.vertices.begin(), mesh.vertices.end(), [&](Vec3f vertex) {
            vertex[along] = ray.origin[along];
            return vertex == ray.origin;
        }));
    }
    EXPECT_TRUE(has_negative_zero);
}

TEST(GrazingRays, RunInThePlaneOfAFace) {
    const TriangleMesh mesh{{{0, 0, 3}, {2, 0, 3}, {0, 2, 3}}, {{0, 1, 2}}};
    for (const Ray& ray : grazing_rays(mesh.view(), 100, 1)) {
        EXPECT_EQ(ray.origin.z, 3.0F);
        EXPECT_EQ(ray.direction.z, 0.0F);
    }
    const TriangleMesh point{{{1, 2, 3}}, {{0, 0, 0}}};
    EXPECT_TRUE(is_traceable(grazing_rays(point.view(), 1, 1)[0]));
}

}  // namespace

}  // namespace coppice::lab
