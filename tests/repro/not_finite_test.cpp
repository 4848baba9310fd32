// A NaN coordinate in a mesh that did not come from a file made the sweep of events loop for ever.

#include "coppice/base/error.h"
#include "coppice/build/build_tree.h"
#include "coppice/geom/point_cloud.h"
#include "coppice/trace/brute_force.h"
#include "coppice/trace/intersect.h"

#include "support/meshes.h"
#include "support/rays.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

namespace coppice::test {
namespace {

constexpr float nan = std::numeric_limits<float>::quiet_NaN();
constexpr float infinity = std::numeric_limits<float>::infinity();

std::string error_of(PrimitiveSetView primitives) {
    try {
        static_cast<void>(build_kd_tree(primitives));
    } catch (const Error& error) {
        EXPECT_EQ(error.code(), ErrorCode::invalid_argument);
        return error.what();
    }
    return "";
}

TEST(NotFinite, BoxesAreRefused) {
    for (const float bad : {nan, infinity, -infinity}) {
        std::vector<Vec3f> points(1000, Vec3f{1, 2, 3});
        points[700].y = bad;
        points[900].z = bad;
        EXPECT_EQ(error_of(PointCloudView(points)), "primitive 700 has no finite box");
    }
    TriangleMesh mesh = make_soup(50'000, 0.1F, 1);  // checked in parallel, reported in order
    for (const std::size_t id : {49'999U, 33'333U, 16'500U}) {
        mesh.vertices[3 * id].x = infinity;
    }
    EXPECT_EQ(error_of(mesh.view()), "primitive 16500 has no finite box");
}

TEST(NotFinite, TrianglesWithOneNanCornerDoNoHarm) {
    TriangleMesh mesh = make_soup(1000, 0.2F, 2);
    Random random(3);
    for (std::size_t id = 0; id < 1000; id += 20) {
        mesh.vertices[3 * id + random.below(3)][static_cast<Axis>(random.below(3))] = nan;
    }
    for (const double rate : {1.0, 0.1}) {
        const KdTree tree = build_kd_tree(mesh.view(), {.sample = {.rate = rate}});
        Random rays(4);
        for (int i = 0; i < 500; ++i) {
            const Ray ray = random_line_through({{0, 0, 0}, {1, 1, 1}}, rays);
            const auto hit = intersect(tree, mesh.view(), ray);
            const auto expected = brute_force_intersect(mesh.view(), ray);
            ASSERT_EQ(hit.has_value(), expected.has_value());
            EXPECT_TRUE(!hit || hit->prim == expected->prim);
        }
    }
}

}  // namespace
}  // namespace coppice::test
