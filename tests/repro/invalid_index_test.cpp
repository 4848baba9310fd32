// A mesh with an index that no vertex has was read out of bounds by whatever it was given to.

#include "coppice/base/error.h"
#include "coppice/builders/build_tree.h"
#include "coppice/builders/estimate.h"
#include "coppice/query/signed_distance.h"
#include "coppice/scene/scene.h"
#include "coppice/tree/validate.h"

#include "support/meshes.h"

#include <gtest/gtest.h>

#include <functional>

namespace coppice::test {
namespace {

std::string error_of(const std::function<void()>& enter) {
    try {
        enter();
        return "none";
    } catch (const Error& error) {
        EXPECT_EQ(error.code(), ErrorCode::invalid_argument);
        return error.what();
    }
}

// Two bad triangles in different chunks of the builders' passes: the first is the one to name.
TEST(InvalidIndex, IsRefusedWhereAMeshEnters) {
    const TriangleMesh good = make_soup(40'000, 0.02F, 1);
    TriangleMesh bad = good;
    const auto vertex_count = static_cast<std::uint32_t>(bad.vertices.size());
    bad.triangles[39'000][0] = 0xffffffff;
    bad.triangles[17'000][2] = vertex_count;
    const std::string expected = "triangle 17000 has the vertex index " +
                                 std::to_string(vertex_count) + ", but there are " +
                                 std::to_string(vertex_count) + " vertices";
    const TriangleMeshView view = bad.view();
    EXPECT_EQ(error_of([&] { Scene{bad}; }), expected);
    EXPECT_EQ(error_of([&] { static_cast<void>(build_kd_tree(view)); }), expected);
    for (const Bvh8Preset preset :
         {Bvh8Preset::automatic, Bvh8Preset::fast, Bvh8Preset::balanced, Bvh8Preset::quality}) {
        EXPECT_EQ(error_of([&] { static_cast<void>(build_bvh8(view, {.preset = preset})); }),
                  expected);
    }
    EXPECT_EQ(error_of([&] { static_cast<void>(estimate_kd_tree(view, {})); }), expected);
    EXPECT_EQ(error_of([&] { static_cast<void>(estimate_bvh8(view, {})); }), expected);
    EXPECT_EQ(error_of([&] { SignedDistance(view, MeshSearch{Bvh8()}); }), expected);
    EXPECT_EQ(error_of([&] { static_cast<void>(validate(KdTree(), view)); }), expected);
    EXPECT_EQ(error_of([&] { static_cast<void>(validate(Bvh8(), view)); }), expected);
    EXPECT_EQ(error_of([&] { static_cast<void>(build_kd_tree(good.view())); }), "none");
}

TEST(InvalidIndex, OfASmallMeshIsRefused) {
    const TriangleMesh mesh{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}, {0, 1, 7}}};
    EXPECT_EQ(error_of([&] { Scene{mesh}; }),
              "triangle 1 has the vertex index 7, but there are 3 vertices");
}

}  // namespace
}  // namespace coppice::test
