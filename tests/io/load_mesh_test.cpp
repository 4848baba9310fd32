#include "coppice/io/load_mesh.h"

#include "io/test_files.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <sys/types.h>

namespace coppice::test {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::StartsWith;

/// The corners of all triangles.
std::vector<Triangle> triangles_of(const TriangleMesh& mesh) {
    std::vector<Triangle> triangles;
    for (std::uint32_t id = 0; id < mesh.view().size(); ++id) {
        triangles.push_back(mesh.view().triangle(id));
    }
    return triangles;
}

class LoadMeshFormat : public testing::TestWithParam<const char*> {};

TEST_P(LoadMeshFormat, GivesTheSameTetrahedron) {
    const std::string extension = GetParam();
    const bool is_ours = extension == "obj" || extension == "ply" || extension == "off";
    if (!is_ours && !can_load_scene_files()) GTEST_SKIP() << "built without Assimp";
    LoadReport report;
    const TriangleMesh mesh = load_mesh(data_file("tetrahedron." + extension), &report);
    constexpr Vec3f o{0, 0, 0};
    constexpr Vec3f x{1, 0, 0};
    constexpr Vec3f y{0, 1, 0};
    constexpr Vec3f z{0, 0, 1};
    EXPECT_THAT(triangles_of(mesh), ElementsAre(Triangle{o, y, x}, Triangle{o, x, z},
                                                Triangle{o, z, y}, Triangle{x, y, z}));
    EXPECT_EQ(report.face_count, 4U);
    EXPECT_EQ(report.zero_area_triangles.count, 0U);
    EXPECT_EQ(report.duplicate_triangles.count, 0U);
    EXPECT_FALSE(report.format.empty());
}

INSTANTIATE_TEST_SUITE_P(All, LoadMeshFormat,
                         testing::Values("obj", "ply", "stl", "off", "gltf", "dae", "x3d"),
                         [](const auto& each) { return std::string(each.param); });

TEST(LoadMesh, RefusesWhatIsNoFile) {
    const std::filesystem::path folder = fresh_folder();
    std::filesystem::create_directory(folder / "folder.obj");
    ASSERT_EQ(mkfifo((folder / "pipe.obj").c_str(), 0600), 0);
    for (const char* const extension : {"obj", "ply", "stl", "obj.gz", "xyz"}) {
        EXPECT_EQ(error_of_file(folder / (std::string("a.") + extension), ErrorCode::io),
                  std::string("a.") + extension + ": no such file");
    }
    EXPECT_EQ(error_of_file(folder / "folder.obj", ErrorCode::io),
              "folder.obj: is a directory, not a file");
    EXPECT_EQ(error_of_file(folder / "pipe.obj", ErrorCode::io), "pipe.obj: not a regular file");
    EXPECT_EQ(error_of_file("/dev/zero", ErrorCode::io), "zero: not a regular file");
}

TEST(LoadMesh, RefusesAnUnreadableFile) {
    const std::filesystem::path file = make_file("a.obj", "v 0 0 0\n");
    std::filesystem::permissions(file, std::filesystem::perms::none);
    const WithoutRights without_rights;
    EXPECT_EQ(error_of_file(file, ErrorCode::io), "a.obj: cannot open: Permission denied");
}

TEST(LoadMesh, FollowsSymbolicLinks) {
    const std::filesystem::path link = fresh_folder() / "a.obj";
    std::filesystem::create_symlink(data_file("tetrahedron.obj"), link);
    EXPECT_EQ(load_mesh(link).triangles.size(), 4U);
}

TEST(LoadMesh, RefusesEmptyFiles) {
    if (!can_load_scene_files()) GTEST_SKIP() << "built without Assimp";
    for (const char* const name : {"a.obj", "a.ply", "a.stl", "a.gltf", "a.obj.gz", "a.ply.gz"}) {
        EXPECT_EQ(error_of(name, ""), std::string(name) + ": empty file");
    }
    for (const char* const name : {"a.obj", "a.ply", "a.stl", "a.dae"}) {
        EXPECT_EQ(error_of(name, " \r\n\t\n"), std::string(name) + ": empty file");
    }
    EXPECT_EQ(error_of("a.obj.gz", gzipped("")), "a.obj.gz: empty file");
    EXPECT_EQ(error_of("a.ply.gz", gzipped("\n\n")), "a.ply.gz: empty file");
}

TEST(LoadMesh, RefusesUnknownExtensions) {
    const std::string error = error_of("a.xyz", "x", ErrorCode::unsupported);
    EXPECT_THAT(error, StartsWith("a.xyz: unknown mesh file extension '.xyz'"));
    EXPECT_EQ(error.find("Assimp") == std::string::npos, can_load_scene_files());
    EXPECT_EQ(error_of("a", "x", ErrorCode::unsupported),
              "a: the name has no extension, and the contents are not OBJ, PLY or OFF: add the "
              "extension");
    EXPECT_THAT(error_of("a.stl.gz", gzipped("x"), ErrorCode::unsupported),
                StartsWith("a.stl.gz: unknown mesh file extension '.stl.gz'"));
}

TEST(LoadMesh, RefusesDamagedGzipFiles) {
    std::string text;
    for (int i = 0; i < 20'000; ++i) {
        text += "v " + std::to_string(i) + " 0 0\n";
    }
    const std::string packed = gzipped(text + "f 1 2 3\n");
    for (const std::size_t size :
         {std::size_t{3}, packed.size() / 2, packed.size() - 9, packed.size() - 1}) {
        EXPECT_THAT(error_of("a.obj.gz", packed.substr(0, size)),
                    StartsWith("a.obj.gz: damaged gzip file: "))
            << size << " of " << packed.size() << " bytes";
    }
    std::string wrong_checksum = packed;
    wrong_checksum[packed.size() - 8] = static_cast<char>(~wrong_checksum[packed.size() - 8]);
    EXPECT_EQ(error_of("a.obj.gz", wrong_checksum),
              "a.obj.gz: damaged gzip file: incorrect data check");
    EXPECT_EQ(error_of("a.obj.gz", text), "a.obj.gz: not a gzip file");
    EXPECT_EQ(error_of("a.ply.gz", "\x1f"), "a.ply.gz: not a gzip file");
}

TEST(LoadMesh, CountsWhatIsOdd) {
    const auto [mesh, report] = load("a.obj",
                                     "v 0 0 0\n"        // 0
                                     "v 1 0 0\n"        // 1
                                     "v 0 1 0\n"        // 2
                                     "v 5 5 5\n"        // 3, unused
                                     "v -0 0 0\n"       // 4, as 0
                                     "v 2 0 0\n"        // 5
                                     "f 1 2 3\n"        // triangle 0
                                     "f 3 1 2\n"        // 1, as 0
                                     "f 2 5 3\n"        // 2, as 0 by position
                                     "f 1 2 6\n"        // 3, no area
                                     "f 1 1 2\n"        // 4, no area
                                     "f 1 2\n"          // face 5
                                     "f -1 -5 -4 -6\n"  // face 6: triangles 5 and 6
                                     "p 1\n");
    EXPECT_EQ(mesh.triangles.size(), 7U);
    EXPECT_EQ(report.face_count, 7U);
    EXPECT_THAT(report.duplicate_triangles.first, ElementsAre(1, 2));
    EXPECT_EQ(report.duplicate_triangles.count, 2U);
    EXPECT_THAT(report.duplicate_vertices.first, ElementsAre(4));
    EXPECT_THAT(report.unused_vertices.first, ElementsAre(3));
    EXPECT_THAT(report.zero_area_triangles.first, ElementsAre(3, 4));
    EXPECT_THAT(report.degenerate_faces.first, ElementsAre(5));
    EXPECT_THAT(report.polygons.first, ElementsAre(6));
    EXPECT_EQ(report.negative_index_count, 4U);
    EXPECT_EQ(report.ignored_line_count, 1U);
}

TEST(LoadMesh, TakesOneTriangleWithAllVerticesEqual) {
    const auto [mesh, report] = load("a.obj", "v 1 2 3\nv 1 2 3\nv 1 2 3\nf 1 2 3\n");
    EXPECT_EQ(mesh.triangles.size(), 1U);
    EXPECT_EQ(report.duplicate_vertices.count, 2U);
    EXPECT_EQ(report.zero_area_triangles.count, 1U);
    EXPECT_EQ(report.duplicate_triangles.count, 0U);
    EXPECT_EQ(report.unused_vertices.count, 0U);
}

TEST(LoadMesh, KeepsTheFirstPlacesOfManyLoadIssue) {
    std::string text = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";
    for (int i = 0; i < 100'000; ++i) {
        text += "f 1 2 3\n";
    }
    const auto [mesh, report] = load("a.obj", text);
    EXPECT_EQ(report.duplicate_triangles.count, 99'999U);
    EXPECT_THAT(report.duplicate_triangles.first, ElementsAre(1, 2, 3, 4, 5, 6, 7, 8));
}

TEST(LoadMesh, CountsADuplicateOnlyForTheSameThreeCorners) {
    const auto [mesh, report] =
        load("a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 2 3\nf 1 2 4\nf 1 3 4\nf 4 3 2\n");
    EXPECT_EQ(report.duplicate_triangles.count, 0U);
    EXPECT_EQ(report.duplicate_vertices.count, 0U);
}

TEST(LoadMesh, CountsDuplicateVerticesAndNegativeIndices) {
    const auto [mesh, report] = load("a.obj", "v 0 0 0\nv 0 0 0\nv 0 1 0\nf 1 2 3\nf -1 -2 -3\n");
    EXPECT_EQ(report.duplicate_vertices.count, 1U);
    EXPECT_THAT(report.duplicate_vertices.first, ElementsAre(1));
    EXPECT_EQ(report.negative_index_count, 3U);
    EXPECT_THAT(report.file, HasSubstr("a.obj"));
}

}  // namespace
}  // namespace coppice::test
