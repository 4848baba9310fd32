// From within a closed mesh no ray gets out: not through a vertex, not through an edge, not along a
// plane that trees, edges and rays share; near the origin and where floats are coarse; with trees
// of all methods and every instruction set. The slow test has larger meshes and as many rays as one
// likes.

#include "support/effort.h"
#include "support/scene_matrix.h"
#include "trace/closed_meshes.h"

namespace coppice::test {
namespace {

class ClosedMesh : public testing::TestWithParam<NamedScene> {};

TEST_P(ClosedMesh, LetsNoRayOut) {
    const TriangleMesh mesh = GetParam().make();
    const InsideRays rays(mesh, 17);
    for_all_trees(mesh, [&](const std::string& name, const lab::TracedTree& tree) {
        const Escapes found = count_escapes(rays, tree, effort(12'500), 1);
        EXPECT_EQ(found.misses, 0U) << name << ": ray " << found.first_miss;
    });
}

// A direction on a grid, with zeros of either sign.
Vec3f grid_direction(Random& random) {
    Vec3f direction;
    for (const Axis axis : all_axes) {
        direction[axis] = static_cast<float>(random.below(9)) - 4.0F;
        if (direction[axis] == 0.0F && random.below(2) == 0) direction[axis] = -0.0F;
    }
    return direction;
}

// Origins, directions, vertices and planes on one grid: everything coincides that can.
TEST_P(ClosedMesh, LetsNoRayOnTheGridOut) {
    const TriangleMesh mesh = GetParam().make();
    const Aabb box = bounds_of(mesh.vertices);
    const Vec3f center = 0.5F * (box.lower + box.upper);
    const auto unit = static_cast<float>(box.extent(Axis::y) / 32.0);
    for_all_trees(mesh, [&](const std::string& name, const lab::TracedTree& tree) {
        Random random(8);
        for (int i = 0; i < effort(1000); ++i) {
            Ray ray{.origin = center, .direction = grid_direction(random)};
            for (const Axis axis : all_axes) {
                ray.origin[axis] += unit * (static_cast<float>(random.below(9)) - 4.0F);
            }
            if (!is_traceable(ray)) continue;
            ASSERT_TRUE(tree.intersect(ray) && tree.occluded(ray)) << name << ": ray " << i;
        }
    });
}

INSTANTIATE_TEST_SUITE_P(
    Seed17, ClosedMesh,
    testing::Values(
        NamedScene{"sphere",
                   [] { return on_grid(scaled(make_sphere(24, 31), 16.0F), 0x1p-12F, {}); }},
        NamedScene{"sphere_far_away",
                   [] { return on_grid(scaled(make_sphere(24, 31), 16.0F), 0x1p-6F, far_away); }},
        NamedScene{"grid_cube", [] { return make_grid_cube(16, 1.0F); }},
        NamedScene{"grid_cube_far_away",
                   [] { return on_grid(make_grid_cube(16, 1.0F), 0x1p-6F, far_away); }}),
    scene_name);

}  // namespace
}  // namespace coppice::test
