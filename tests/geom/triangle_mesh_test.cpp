#include "coppice/geom/triangle_mesh.h"

#include "coppice/base/error.h"
#include "coppice/geom/point_cloud.h"
#include "coppice/geom/primitive_set.h"

#include "support/meshes.h"

#include <gtest/gtest.h>

#include <functional>

namespace coppice::test {
namespace {

static_assert(PrimitiveSet<TriangleMeshView>);
static_assert(sizeof(TriangleIndices) == 12, "index arrays are read and written as they are");

TEST(BoundsOf, HoldsThePoints) {
    EXPECT_EQ(bounds_of({}), Aabb{});
    const std::vector<Vec3f> points{{1, 2, 3}, {-1, 5, 3}, {0, 0, 0}};
    EXPECT_EQ(bounds_of(points), (Aabb{{-1, 0, 0}, {1, 5, 3}}));
}

TEST(TriangleMeshView, IsEmptyByDefault) {
    const TriangleMeshView view;
    EXPECT_EQ(view.size(), 0U);
    EXPECT_TRUE(view.vertices().empty());
    EXPECT_EQ(TriangleMesh{}.view().size(), 0U);
}

TEST(TriangleMeshView, SeesTheMesh) {
    const TriangleMesh mesh{{{0, 0, 0}, {1, 0, 0}, {0, 2, 0}, {0, 0, 3}}, {{0, 1, 2}, {3, 2, 1}}};
    const TriangleMeshView view = mesh.view();
    EXPECT_EQ(view.size(), 2U);
    EXPECT_EQ(view.vertices().data(), mesh.vertices.data());
    EXPECT_EQ(view.triangles().data(), mesh.triangles.data());
    EXPECT_EQ(view.triangle(1), (Triangle{Vec3f{0, 0, 3}, Vec3f{0, 2, 0}, Vec3f{1, 0, 0}}));
    EXPECT_EQ(view.bounds(1), (Aabb{{0, 0, 0}, {1, 2, 3}}));
}

TEST(TriangleMeshView, FindsTheFirstInvalidIndex) {
    const TriangleMesh mesh{{{0, 0, 0}, {1, 0, 0}, {0, 2, 0}},
                            {{0, 1, 2}, {2, 1, 0}, {0, 3, 1}, {0, 1, 2}, {7, 0, 9}}};
    const TriangleMeshView view = mesh.view();
    EXPECT_EQ(view.first_invalid(0, 2), 2U) << "none";
    EXPECT_EQ(view.first_invalid(0, 5), 2U);
    EXPECT_EQ(view.first_invalid(3, 5), 4U);
    EXPECT_EQ(view.first_invalid(3, 3), 3U);
    EXPECT_NO_THROW(view.require_valid(0, 2));
    const PrimitiveSetView set(view);
    for (const auto& require : {std::function([&] { view.require_valid(3, 5); }),
                                std::function([&] { set.require_valid(3, 5); })}) {
        try {
            require();
            FAIL() << "it returned";
        } catch (const Error& error) {
            EXPECT_EQ(error.code(), ErrorCode::invalid_argument);
            EXPECT_STREQ(error.what(),
                         "triangle 4 has the vertex index 7, but there are 3 vertices");
        }
    }
    const PointCloudView points(mesh.vertices);
    EXPECT_NO_THROW(PrimitiveSetView(points).require_valid(0, 3)) << "nothing to check";
    const TriangleMesh no_vertices{{}, {{0, 0, 0}}};
    EXPECT_EQ(no_vertices.view().first_invalid(0, 1), 0U);
}

TEST(TriangleMeshView, RefusesMoreTrianglesThanIds) {
    const TriangleIndices none{};
    const auto error_of = [&](std::size_t count) {  // nothing of them is read
        try {
            static_cast<void>(TriangleMeshView({}, std::span(&none, count)));
        } catch (const Error& error) {
            EXPECT_EQ(error.code(), ErrorCode::limit);
            return std::string(error.what());
        }
        return std::string();
    };
    EXPECT_EQ(error_of(0xffffffff), "");
    EXPECT_EQ(error_of(std::size_t{1} << 32),
              "4294967296 triangles are too many; at most 4294967295 are possible");
    const Vec3f point{};
    EXPECT_THROW(PointCloudView(std::span(&point, std::size_t{1} << 32)), Error);
}

TEST(TriangleMeshView, ClipsItsTriangles) {
    const TriangleMesh mesh = make_triangle({Vec3f{0, 0, 0}, Vec3f{2, 0, 0}, Vec3f{0, 2, 0}});
    const Aabb box{{1, 0, 0}, {9, 9, 9}};
    EXPECT_EQ(mesh.view().clipped_bounds(0, box),
              clipped_triangle_bounds(mesh.view().triangle(0), box));
    EXPECT_TRUE(mesh.view().clipped_bounds(0, {{3, 3, 3}, {4, 4, 4}}).is_empty());
}

}  // namespace
}  // namespace coppice::test
