#include "io/test_files.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <thread>

namespace coppice::test {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::StartsWith;

/// The glTF file of tests/data, to be changed.
nlohmann::json tetrahedron_gltf() {
    return nlohmann::json::parse(read_file(data_file("tetrahedron.gltf")));
}

TEST(LoadSceneFile, AppliesTheTransformsOfAllNodesInTheOrderOfTheFile) {
    nlohmann::json gltf = tetrahedron_gltf();
    gltf["nodes"] = nlohmann::json::parse(
        R"([{"children": [1, 2, 3], "translation": [10, 0, 0], "rotation": [0, 0, 1, 0]},
            {"mesh": 0, "scale": [2, 2, 2]},
            {"mesh": 0, "translation": [0, 5, 0]},
            {"translation": [1, 1, 1]}])");
    const auto [mesh, report] = load("a.gltf", gltf.dump());
    // Half a turn around z, then 10 along x.
    EXPECT_THAT(mesh.vertices,
                ElementsAre(Vec3f{10, 0, 0}, Vec3f{8, 0, 0}, Vec3f{10, -2, 0}, Vec3f{10, 0, 2},
                            Vec3f{10, -5, 0}, Vec3f{9, -5, 0}, Vec3f{10, -6, 0}, Vec3f{10, -5, 1}));
    ASSERT_EQ(mesh.triangles.size(), 8U);
    EXPECT_EQ(mesh.triangles[0], (TriangleIndices{0, 2, 1}));
    EXPECT_EQ(mesh.triangles[4], (TriangleIndices{4, 6, 5}));
    EXPECT_EQ(report.face_count, 8U);
    EXPECT_EQ(report.format, "glTF2 Importer");
}

TEST(LoadSceneFile, RefusesFacesThatAssimpDrops) {
    nlohmann::json gltf = tetrahedron_gltf();
    gltf["accessors"][1]["count"] = 3;  // vertex 3 is gone
    EXPECT_EQ(error_of("a.gltf", gltf.dump()),
              "a.gltf: Some faces had out-of-range indices. Those faces were dropped.");
}

TEST(LoadSceneFile, RefusesIndicesOutOfRangeThatAssimpLetsThrough) {
    std::string text = read_file(data_file("tetrahedron.x3d"));
    text.replace(text.find("0 1 3 -1"), 8, "0 1 9 -1");
    EXPECT_THAT(error_of("a.x3d", text), HasSubstr("vertex index 9 out of range (4 vertices)"));
}

TEST(LoadSceneFile, RefusesWhatAssimpRefusesInOneLine) {
    nlohmann::json gltf = tetrahedron_gltf();
    gltf["accessors"][1]["count"] = 400;
    EXPECT_THAT(error_of("a.gltf", gltf.dump()), HasSubstr("out of range"));
    EXPECT_THAT(error_of("a.gltf", "{"), StartsWith("a.gltf: "));
    EXPECT_THAT(error_of("a.dae", "no XML\nat\nall"), StartsWith("a.dae: "));
    EXPECT_THAT(error_of("a.stl", "no STL\nat all"), StartsWith("a.stl: "));
}

TEST(LoadSceneFile, RefusesCoordinatesThatAreNotFinite) {
    std::string text = read_file(data_file("tetrahedron.stl"));
    text.replace(text.find("vertex 0 1 0"), 12, "vertex 0 nan 0");
    EXPECT_EQ(error_of("a.stl", text),
              "a.stl: mesh 'tetrahedron': vertex 1: position (nan, nan, nan) is not finite");
    nlohmann::json gltf = tetrahedron_gltf();
    gltf["nodes"][0]["scale"] = {3e38, 1, 1};
    EXPECT_EQ(error_of("a.gltf", gltf.dump()), "");
    gltf["nodes"].push_back({{"children", {0}}, {"scale", {3e38, 1, 1}}});
    gltf["scenes"][0]["nodes"] = {1};
    EXPECT_THAT(error_of("a.gltf", gltf.dump()), HasSubstr("is not finite"));
}

TEST(LoadSceneFile, RefusesAFileWithoutFaces) {
    EXPECT_EQ(error_of("a.stl", "solid nothing\nendsolid nothing\n"), "a.stl: no faces");
    nlohmann::json gltf = tetrahedron_gltf();
    gltf["meshes"][0]["primitives"][0]["mode"] = 1;  // lines
    EXPECT_EQ(error_of("a.gltf", gltf.dump()), "a.gltf: no faces of three or more corners");
}

TEST(LoadSceneFile, ReadsBinaryStl) {
    std::string file(80, ' ');
    file += binary<std::uint32_t>(2, false);
    for (const float z : {0.0F, 1.5F}) {
        for (const float value : {0.F, 0.F, 1.F, 0.F, 0.F, z, 1.F, 0.F, z, 0.F, 1.F, z}) {
            file += binary(value, false);
        }
        file += std::string(2, '\0');
    }
    const auto [mesh, report] = load("a.stl", file);
    EXPECT_THAT(mesh.vertices,
                ElementsAre(Vec3f{0, 0, 0}, Vec3f{1, 0, 0}, Vec3f{0, 1, 0}, Vec3f{0, 0, 1.5F},
                            Vec3f{1, 0, 1.5F}, Vec3f{0, 1, 1.5F}));
    EXPECT_EQ(mesh.triangles.size(), 2U);
    EXPECT_NE(error_of("a.stl", file.substr(0, file.size() - 20)), "");
}

TEST(LoadSceneFile, KeepsAssimpsWarnings) {
    LoadReport report;
    static_cast<void>(load_mesh(data_file("tetrahedron.dae"), &report));
    EXPECT_EQ(report.warning_count, 1U);
    EXPECT_THAT(report.warnings, ElementsAre(StartsWith("Collada: No material")));
}

TEST(LoadSceneFile, WorksInManyThreadsAtOnce) {
    std::vector<std::uint64_t> warning_counts(8);
    std::vector<std::thread> threads;
    threads.reserve(warning_counts.size());
    for (std::uint64_t& warning_count : warning_counts) {
        threads.emplace_back([&warning_count] {
            LoadReport report;
            static_cast<void>(load_mesh(data_file("tetrahedron.dae"), &report));
            warning_count = report.warning_count;
        });
    }
    for (std::thread& thread : threads) {
        thread.join();
    }
    EXPECT_THAT(warning_counts, testing::Each(1));
}

}  // namespace
}  // namespace coppice::test
