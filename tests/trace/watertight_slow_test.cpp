// The same as watertight_test.cpp at length: COPPICE_WATERTIGHT_RAYS says how many rays each mesh
// is traced with, shared among the trees; COPPICE_WATERTIGHT_SCENE names another closed mesh, as
// scenes/dragon.obj. Prints what it did.

#include "coppice/base/timer.h"
#include "coppice/io/load_mesh.h"

#include "support/scene_matrix.h"
#include "trace/closed_meshes.h"

#include <cstdio>
#include <cstdlib>

namespace coppice::test {
namespace {

std::uint64_t ray_count() {
    const char* wanted = std::getenv("COPPICE_WATERTIGHT_RAYS");
    return wanted == nullptr ? 1'000'000 : static_cast<std::uint64_t>(std::strtod(wanted, nullptr));
}

void expect_watertight(const std::string& title, const TriangleMesh& mesh) {
    const InsideRays rays(mesh, 18);
    const std::uint64_t tree_count = method_registry().size() * available_isas().size();
    const Timer timer;
    std::uint64_t traced = 0;
    std::uint64_t missed = 0;
    for_all_trees(mesh, [&](const std::string& name, const lab::TracedTree& tree) {
        const Escapes found = count_escapes(rays, tree, 1 + ray_count() / tree_count, 0);
        EXPECT_EQ(found.misses, 0U) << name << ": ray " << found.first_miss;
        traced += found.rays;
        missed += found.misses;
    });
    std::printf("%s: %llu triangles, %llu trees, %llu rays, %llu misses, %.1f s\n", title.c_str(),
                static_cast<unsigned long long>(mesh.triangles.size()),
                static_cast<unsigned long long>(tree_count),
                static_cast<unsigned long long>(traced), static_cast<unsigned long long>(missed),
                timer.seconds());
}

class LargeClosedMesh : public testing::TestWithParam<NamedScene> {};

TEST_P(LargeClosedMesh, LetsNoRayOut) {
    expect_watertight(std::string(GetParam().name), GetParam().make());
}

INSTANTIATE_TEST_SUITE_P(
    Seed18, LargeClosedMesh,
    testing::Values(
        NamedScene{"sphere",
                   [] { return on_grid(scaled(make_sphere(100, 151), 64.0F), 0x1p-14F, {}); }},
        NamedScene{"sphere_far_away",
                   [] { return on_grid(scaled(make_sphere(100, 151), 64.0F), 0x1p-6F, far_away); }},
        NamedScene{"grid_cube", [] { return make_grid_cube(64, 4.0F); }},
        NamedScene{"grid_cube_far_away",
                   [] { return on_grid(make_grid_cube(64, 4.0F), 0x1p-6F, far_away); }}),
    scene_name);

// The Stanford dragon is closed once corners at the same place are one, which rays do not ask for.
// It is made 200 units long: where floats are 1/64 apart, nothing would be left of 0.2.
TEST(ClosedMeshOfAFile, LetsNoRayOut) {
    const char* file = std::getenv("COPPICE_WATERTIGHT_SCENE");
    if (file == nullptr) GTEST_SKIP() << "COPPICE_WATERTIGHT_SCENE names no scene";
    TriangleMesh mesh = load_mesh(file);
    expect_watertight(file, mesh);
    const Aabb box = bounds_of(mesh.vertices);
    mesh = scaled(std::move(mesh), static_cast<float>(200.0 / box.extent(box.longest_axis())));
    expect_watertight(std::string(file) + ", far away", on_grid(mesh, 0x1p-6F, far_away));
}

}  // namespace
}  // namespace coppice::test
