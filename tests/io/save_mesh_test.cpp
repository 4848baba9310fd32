#include "coppice/io/save_mesh.h"

#include "io/test_files.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <limits>
#include <random>

namespace coppice::test {
namespace {

/// Vertices of random finite bit patterns among special values, and random triangles.
TriangleMesh random_mesh(std::uint32_t vertex_count, std::uint32_t triangle_count) {
    std::mt19937 random(7);
    TriangleMesh mesh;
    using Limits = std::numeric_limits<float>;
    mesh.vertices = {{0.0F, -0.0F, 1e-30F},
                     {Limits::max(), Limits::lowest(), 1e30F},
                     {Limits::min(), Limits::denorm_min(), -Limits::denorm_min()},
                     {0.1F, 1.0F / 3.0F, 16777217.0F}};
    const auto random_float = [&] {
        float value = Limits::infinity();
        while (!std::isfinite(value)) {
            value = std::bit_cast<float>(static_cast<std::uint32_t>(random()));
        }
        return value;
    };
    while (mesh.vertices.size() < vertex_count) {
        mesh.vertices.push_back({random_float(), random_float(), random_float()});
    }
    std::uniform_int_distribution<std::uint32_t> id(0, vertex_count - 1);
    while (mesh.triangles.size() < triangle_count) {
        mesh.triangles.push_back({id(random), id(random), id(random)});
    }
    return mesh;
}

/// What save_mesh says, without the folder; "" if it saves.
std::string save_error(const TriangleMesh& mesh, const std::filesystem::path& file,
                       ErrorCode expected) {
    try {
        save_mesh(mesh.view(), file);
    } catch (const Error& error) {
        EXPECT_EQ(error.code(), expected) << error.what();
        return std::string(error.what()).substr(file.parent_path().string().size() + 1);
    }
    return "";
}

class SaveMesh : public testing::TestWithParam<const char*> {};

INSTANTIATE_TEST_SUITE_P(Format, SaveMesh, testing::Values("obj", "ply"),
                         [](const auto& each) { return std::string(each.param); });

TEST_P(SaveMesh, IsReadBackBitForBit) {
    const std::string extension = std::string(".") + GetParam();
    const TriangleMesh mesh = random_mesh(60'000, 100'000);  // several chunks
    const std::filesystem::path folder = fresh_folder();
    save_mesh(mesh.view(), folder / ("a" + extension));
    EXPECT_EQ(bits_of(load_mesh(folder / ("a" + extension))), bits_of(mesh));
    const std::string packed = gzipped(read_file(folder / ("a" + extension)));
    EXPECT_EQ(bits_of(load("b" + extension + ".gz", packed).mesh), bits_of(mesh));
}

TEST_P(SaveMesh, ReplacesAFileAndLeavesNothingElse) {
    const std::filesystem::path file =
        make_file(std::string("a.") + GetParam(), std::string(100'000, 'x'));
    const TriangleMesh mesh = random_mesh(4, 2);
    save_mesh(mesh.view(), file);
    EXPECT_EQ(bits_of(load_mesh(file)), bits_of(mesh));
    EXPECT_EQ(std::distance(std::filesystem::directory_iterator(file.parent_path()), {}), 1);
}

TEST_P(SaveMesh, RefusesWhatLoadMeshWouldRefuse) {
    const std::filesystem::path file = fresh_folder() / (std::string("a.") + GetParam());
    const std::string name = file.filename().string();
    TriangleMesh mesh = random_mesh(4, 2);
    mesh.triangles[1][2] = 4;
    EXPECT_EQ(save_error(mesh, file, ErrorCode::invalid_argument),
              name + ": the mesh has a vertex index out of range");
    mesh = random_mesh(4, 2);
    mesh.vertices[3].y = std::numeric_limits<float>::quiet_NaN();
    EXPECT_EQ(save_error(mesh, file, ErrorCode::invalid_argument),
              name + ": the mesh has a vertex that is not finite");
    EXPECT_EQ(save_error(TriangleMesh{}, file, ErrorCode::unsupported),
              name + ": the mesh has no vertices");
    EXPECT_FALSE(std::filesystem::exists(file));
}

TEST(SaveMeshPly, KeepsPointClouds) {
    const std::filesystem::path folder = fresh_folder();
    const TriangleMesh points = random_mesh(100, 0);
    save_mesh(points.view(), folder / "a.ply");
    EXPECT_EQ(bits_of(load_mesh(folder / "a.ply")), bits_of(points));
    EXPECT_EQ(save_error(points, folder / "a.obj", ErrorCode::unsupported),
              "a.obj: the mesh has no triangles: save a point cloud as .ply");
}

TEST(SaveMeshObj, WritesTheFewestDigits) {
    const std::filesystem::path file = fresh_folder() / "a.OBJ";
    save_mesh(TriangleMesh{{{0.1F, -1e-30F, 3}, {1e30F, 0.5F, -0.0F}}, {{0, 1, 0}}}.view(), file);
    EXPECT_EQ(read_file(file), "v 0.1 -1e-30 3\nv 1e+30 0.5 -0\nf 1 2 1\n");
}

TEST(SaveMeshName, MustEndInObjOrPly) {
    const std::filesystem::path folder = fresh_folder();
    for (const char* const name : {"a.stl", "a", "a.obj.gz"}) {
        EXPECT_EQ(save_error(random_mesh(4, 2), folder / name, ErrorCode::unsupported),
                  std::string(name) + ": cannot write '" +
                      std::filesystem::path(name).extension().string() +
                      "' files, only .obj and .ply");
    }
}

}  // namespace
}  // namespace coppice::test
