// Damaged files: whatever the bytes, load_mesh returns a valid mesh or throws Error, quickly.

#include "io/test_files.h"

#include <gtest/gtest.h>

#include <random>

namespace coppice::test {
namespace {

std::string mutated(std::string bytes, std::mt19937& random) {
    const auto below = [&](std::size_t n) { return static_cast<std::size_t>(random()) % n; };
    const std::size_t changes = 1 + below(4);
    for (std::size_t i = 0; i < changes && !bytes.empty(); ++i) {
        const std::size_t at = below(bytes.size());
        switch (below(5)) {
            case 0:
                bytes[at] = static_cast<char>(random());
                break;
            case 1:
                bytes[at] = static_cast<char>(bytes[at] ^ (1 << below(8)));
                break;
            case 2:
                bytes.resize(at);
                break;
            case 3:
                bytes.erase(at, 1 + below(8));
                break;
            default:
                bytes.insert(at, bytes.substr(below(bytes.size()), 1 + below(16)));
                break;
        }
    }
    return bytes;
}

void expect_mesh_or_error(const std::filesystem::path& file) {
    try {
        LoadReport report;
        const TriangleMesh mesh = load_mesh(file, &report);
        for (const TriangleIndices& corners : mesh.triangles) {
            for (const std::uint32_t corner : corners) {
                ASSERT_LT(corner, mesh.vertices.size());
            }
        }
        EXPECT_EQ(report.triangle_count, mesh.triangles.size());
    } catch (const Error& error) {
        EXPECT_EQ(std::string(error.what()).find('\n'), std::string::npos) << error.what();
    }
}

class Mutation : public testing::TestWithParam<const char*> {};

INSTANTIATE_TEST_SUITE_P(Seed1, Mutation,
                         testing::Values("tetrahedron.obj", "tetrahedron.ply", "binary.ply",
                                         "tetrahedron.off", "binary.ply.gz"),
                         [](const auto& each) {
                             std::string name = each.param;
                             std::replace(name.begin(), name.end(), '.', '_');
                             return name;
                         });

TEST_P(Mutation, GivesAMeshOrAnError) {
    const std::string name = GetParam();
    std::string good;
    if (name.starts_with("binary")) {
        good =
            "ply\nformat binary_big_endian 1.0\nelement vertex 3\nproperty float x\n"
            "property float y\nproperty float z\nelement face 2\n"
            "property list uint short vertex_index\nproperty uchar kind\nend_header\n";
        good += std::string(36, '\1');
        for (int i = 0; i < 2; ++i) {
            good += std::string("\0\0\0\3\0\0\0\1\0\2\0", 11);
        }
    } else {
        good = read_file(data_file(name));
    }
    good = name.ends_with(".gz") ? gzipped(good) : good;
    ASSERT_EQ(error_of(name, good), "");
    std::mt19937 random(1);
    const std::filesystem::path file = fresh_folder() / name;
    for (int i = 0; i < 1000; ++i) {
        std::filesystem::remove(file);  // some file systems sync a file that is cut and rewritten
        std::ofstream(file, std::ios::binary) << mutated(good, random);
        expect_mesh_or_error(file);
    }
}

}  // namespace
}  // namespace coppice::test
