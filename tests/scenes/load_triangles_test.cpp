#include "scenes/load_triangles.h"

#include "coppice/base/error.h"

#include "support/lab_scenes.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace coppice::lab {

namespace {

TEST(LoadTriangles, LoadsAMeshAndReportsOnIt) {
    const test::TemporaryFolder folder;
    LoadReport report;
    const TriangleMesh mesh =
        load_triangles(folder.make_scene("hills.ply", "terrain", 200), &report);
    EXPECT_EQ(mesh.triangles.size(), report.triangle_count);
    EXPECT_FALSE(mesh.triangles.empty());
}

TEST(LoadTriangles, RefusesAPointCloud) {
    const test::TemporaryFolder folder;
    try {
        static_cast<void>(load_triangles(folder.make_point_cloud("cloud.ply")));
        FAIL() << "no error";
    } catch (const Error& error) {
        EXPECT_EQ(error.code(), ErrorCode::unsupported);
        EXPECT_THAT(error.what(), testing::HasSubstr("cloud.ply: has no triangles"));
    }
}

}  // namespace

}  // namespace coppice::lab
