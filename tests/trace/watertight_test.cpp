// From within a closed mesh no ray gets out: not through a vertex, not through an edge, not along a
// grid that planes of trees, edges and rays share. For both kinds of trees.

#include "coppice/build/build_tree.h"
#include "coppice/trace/intersect.h"
#include "coppice/trace/wide_tracer.h"

#include "support/meshes.h"
#include "support/random.h"
#include "support/rays.h"
#include "support/scene_matrix.h"

#include <gtest/gtest.h>

#include <vector>

namespace coppice::test {
namespace {

// A cube around the origin, on a grid, so that many planes hold many edges.
TriangleMesh make_grid_cube() {
    TriangleMesh mesh;
    for (const Axis axis : all_axes) {
        for (const float side : {-1.0F, 1.0F}) {
            Vec3f origin{-1, -1, -1};
            Vec3f u;
            Vec3f v;
            origin[axis] = side;
            u[next_axis(axis)] = 0.125F;
            v[next_axis(next_axis(axis))] = 0.125F;
            mesh = joined(std::move(mesh), make_sheet(16, origin, u, v));
        }
    }
    return mesh;
}

class ClosedMesh : public testing::TestWithParam<NamedScene> {
protected:
    void SetUp() override {
        for (const Clipping clipping : {Clipping::perfect, Clipping::bounding_box}) {
            for (const double rate : {1.0, 0.05}) {
                kd_.push_back(build_kd_tree(
                    mesh_.view(), {.sample = {.rate = rate}, .split = {.clipping = clipping}}));
            }
        }
        for (const Isa isa : available_isas()) {
            wide_.emplace_back(build_wide_bvh(mesh_.view()), isa);
        }
    }

    [[nodiscard]] testing::AssertionResult is_caught(const Ray& ray) const {
        for (const KdTree& tree : kd_) {
            if (!intersect(tree, mesh_.view(), ray) || !occluded(tree, mesh_.view(), ray)) {
                return testing::AssertionFailure() << "passes a k-d tree";
            }
        }
        for (const WideTracer& tracer : wide_) {
            if (!tracer.intersect(ray) || !tracer.occluded(ray)) {
                return testing::AssertionFailure() << "passes a wide tree";
            }
        }
        return testing::AssertionSuccess();
    }

    TriangleMesh mesh_ = GetParam().make();
    std::vector<KdTree> kd_;
    std::vector<WideTracer> wide_;
};

TEST_P(ClosedMesh, LetsNoRayAimedAtAVertexOrEdgeOut) {
    const Aabb inner{{-0.3F, -0.3F, -0.3F}, {0.3F, 0.3F, 0.3F}};
    Random random(17);
    for (int i = 0; i < 4000; ++i) {
        const Triangle any = mesh_.view().triangle(random.below(mesh_.view().size()));
        const Vec3d a = to_double(any[0]);
        const double share = i % 2 == 0 ? 0.5 : random.unit();
        const Vec3f on_edge = to_float(a + share * (to_double(any[1]) - a));
        const Vec3f from = i % 3 == 0 ? Vec3f{} : random.in_box(inner);
        for (const Vec3f& target : {any[2], on_edge, to_float(random.direction())}) {
            ASSERT_TRUE(is_caught(ray_through(from, target))) << i;
        }
    }
}

TEST_P(ClosedMesh, LetsNoRayOnTheGridOut) {
    Random random(8);
    for (int i = 0; i < 4000; ++i) {
        Ray ray;
        for (const Axis axis : all_axes) {
            ray.origin[axis] = 0.0625F * (static_cast<float>(random.below(9)) - 4.0F);
            ray.direction[axis] = static_cast<float>(random.below(9)) - 4.0F;
            if (ray.direction[axis] == 0.0F && random.below(2) == 0) ray.direction[axis] = -0.0F;
        }
        if (!is_traceable(ray)) continue;
        ASSERT_TRUE(is_caught(ray)) << i;
    }
}

INSTANTIATE_TEST_SUITE_P(Seed17, ClosedMesh,
                         testing::Values(NamedScene{"sphere", [] { return make_sphere(24, 31); }},
                                         NamedScene{"grid_cube", make_grid_cube}),
                         scene_name);

}  // namespace
}  // namespace coppice::test
