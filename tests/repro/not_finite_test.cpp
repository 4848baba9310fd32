// A NaN coordinate in a mesh that did not come from a file made the sweep of events loop for ever.

#include "coppice/base/error.h"
#include "coppice/builders/build_tree.h"
#include "coppice/builders/estimate.h"
#include "coppice/geom/point_cloud.h"

#include "support/meshes.h"
#include "support/numbers.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace coppice::test {
namespace {

template <typename Build>
std::string error_of_build(Build&& build) {
    try {
        static_cast<void>(build());
    } catch (const Error& error) {
        EXPECT_EQ(error.code(), ErrorCode::invalid_argument);
        return error.what();
    }
    return "";
}

std::string error_of(PrimitiveSetView primitives) {
    return error_of_build([&] { return build_kd_tree(primitives); });
}

std::string error_of_bvh8(TriangleMeshView mesh) {
    return error_of_build([&] { return build_bvh8(mesh); });
}

TEST(NotFinite, BoxesAreRefused) {
    for (const float bad : {nan, infinity, -infinity}) {
        std::vector<Vec3f> points(1000, Vec3f{1, 2, 3});
        points[700].y = bad;
        points[900].z = bad;
        EXPECT_EQ(error_of(PointCloudView(points)),
                  "primitive 700 has a box that is not finite: fix or remove it");
    }
    TriangleMesh mesh = make_soup(50'000, 0.1F, 1);  // checked in parallel, reported in order
    for (const std::size_t id : {49'999U, 33'333U, 16'500U}) {
        mesh.vertices[3 * id].x = infinity;
    }
    EXPECT_EQ(error_of(mesh.view()),
              "primitive 16500 has a box that is not finite: fix or remove it");
}

// The box of the other two corners is finite: such triangles were built on in silence, or another
// one was named.
TEST(NotFinite, TrianglesWithOneNanCornerAreRefused) {
    const TriangleMesh mesh = make_soup(1000, 0.2F, 2);
    for (const std::size_t id : {900U, 500U, 100U}) {
        for (const std::size_t corner : {0U, 1U, 2U}) {
            TriangleMesh bad = mesh;
            bad.vertices[3 * id + corner].y = nan;
            bad.vertices[std::size_t{3} * 950].x = infinity;
            const std::string expected = "primitive " + std::to_string(id) +
                                         " has a box that is not finite: fix or remove it";
            EXPECT_EQ(error_of(bad.view()), expected);
            EXPECT_EQ(error_of_bvh8(bad.view()), expected);
        }
    }
}

// Estimates, which a limit on memory asks for, swept the NaN of their sample for ever.
TEST(NotFinite, BoxesAreRefusedByEstimates) {
    TriangleMesh mesh = make_soup(50'000, 0.1F, 1);
    for (std::size_t id = 7; id < mesh.triangles.size(); id += 10) {
        mesh.vertices[3 * id].x = nan;
    }
    const BuildControl limit{.memory_limit_bytes = std::uint64_t{1} << 40};
    const std::string expected = "primitive 7 has a box that is not finite: fix or remove it";
    EXPECT_EQ(error_of_build([&] { return estimate_kd_tree(mesh.view(), {}); }), expected);
    EXPECT_EQ(error_of_build([&] { return estimate_bvh8(mesh.view(), {}); }), expected);
    EXPECT_EQ(error_of_build([&] { return build_kd_tree(mesh.view(), {}, limit); }), expected);
    EXPECT_EQ(error_of_build([&] { return build_bvh8(mesh.view(), {}, limit); }), expected);
}

}  // namespace
}  // namespace coppice::test
