// The second look at all traversals: rays of the kinds that `coppice trace` sends, over the
// procedural scenes, against every triangle. Hits must be identical, ids of ties included.

#include "coppice/builders/build_tree.h"
#include "coppice/builders/method.h"
#include "coppice/trace/brute_force.h"
#include "coppice/trace/bvh8_tracer.h"
#include "coppice/trace/intersect.h"

#include "scenes/hard_rays.h"
#include "scenes/ray_sets.h"
#include "support/scene_matrix.h"

#include <gtest/gtest.h>

#include <vector>

namespace coppice::test {
namespace {

// Some rays of each of the six kinds, with what they hit.
struct Expected {
    explicit Expected(TriangleMeshView mesh) {
        constexpr std::uint64_t seed = 41;
        const Aabb box = bounds_of(mesh.vertices());
        // No camera stands outside a scene that fills the range of float.
        render::CameraWish wish;
        if (box.extent(box.longest_axis()) > 1e38) wish = {.eye = Vec3f{}, .look_at = box.upper};
        const render::Camera camera = render::frame_box(box, wish, 1.0);
        rays = lab::primary_rays(camera, 7);
        add_hits(mesh);
        const std::vector<Hit> primary = hits;
        const std::span<const Ray> seen = std::span(rays).first(primary.size());
        const auto shadow = lab::shadow_rays(mesh, seen, primary, place_light(camera, box));
        const auto diffuse = lab::diffuse_rays(mesh, seen, primary, seed);
        for (const auto& more :
             {shadow, diffuse, lab::random_rays(mesh, 30, seed), lab::axis_rays(mesh, 30, seed),
              lab::grazing_rays(mesh, 30, seed)}) {
            rays.insert(rays.end(), more.begin(), more.end());
        }
        add_hits(mesh);
    }

    void add_hits(TriangleMeshView mesh) {
        for (std::size_t i = hits.size(); i < rays.size(); ++i) {
            hits.push_back(brute_force_intersect(mesh, rays[i]).value_or(Hit{}));
        }
    }

    std::vector<Ray> rays;
    std::vector<Hit> hits;
};

// `closest(ray)` and `any(ray)` against what is expected.
template <typename Closest, typename Any>
void compare(const Expected& expected, Closest&& closest, Any&& any) {
    for (std::size_t i = 0; i < expected.rays.size(); ++i) {
        const Hit& hit = expected.hits[i];
        const Hit found = closest(expected.rays[i]).value_or(Hit{});
        ASSERT_EQ(found.t, hit.t) << "ray " << i;
        ASSERT_EQ(found.prim, hit.prim) << "ray " << i;
        ASSERT_EQ(found.u, hit.u) << "ray " << i;
        ASSERT_EQ(found.v, hit.v) << "ray " << i;
        ASSERT_EQ(any(expected.rays[i]), hit.is_hit()) << "ray " << i;
    }
}

class Oracle : public testing::TestWithParam<NamedScene> {};

TEST_P(Oracle, AgreesWithTreesOfAllMethods) {
    const TriangleMesh mesh = GetParam().make();
    const Expected expected(mesh.view());
    for (const Method& method : method_registry()) {
        SCOPED_TRACE(method.name);
        if (method.tree() == TreeKind::kd) {
            const KdTree tree = build_kd_tree(mesh.view(), method.kd_options()).tree;
            compare(
                expected, [&](const Ray& ray) { return intersect(tree, mesh.view(), ray); },
                [&](const Ray& ray) { return occluded(tree, mesh.view(), ray); });
            continue;
        }
        for (const Isa isa : available_isas()) {
            SCOPED_TRACE(name_of(isa));
            const Bvh8Tracer tracer(build_bvh8(mesh.view(), method.bvh8_options()).tree, isa);
            compare(
                expected, [&](const Ray& ray) { return tracer.intersect(ray); },
                [&](const Ray& ray) { return tracer.occluded(ray); });
        }
    }
}

INSTANTIATE_TEST_SUITE_P(Seed41, Oracle, testing::ValuesIn(scene_matrix()), scene_name);

}  // namespace
}  // namespace coppice::test
