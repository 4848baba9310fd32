// The program of docs/tutorial.md: a mesh, its tree, rays, what is near a point, and a tree from a
// sample.
#include <coppice/coppice.h>

#include <array>
#include <cstdio>
#include <vector>

int main() {
    // A mesh and its tree.
    const coppice::Scene scene(coppice::load_mesh("bunny.obj"));
    const coppice::BuildReport& built = scene.build_report();
    std::printf("%u triangles, %.1f bytes each, built in %.3f s\n", built.primitive_count,
                static_cast<double>(built.tree_bytes) / built.primitive_count,
                built.stages.wall_seconds());

    // What a ray hits first.
    const coppice::Ray ray{.origin = {0, 0, -5}, .direction = {0, 0, 1}};
    if (const auto hit = scene.intersect(ray)) {
        std::printf("triangle %u at t = %g\n", hit->prim, hit->t);
    }

    // Whether anything is in the way, and everything that is, in order.
    std::printf("%s\n", scene.occluded(ray) ? "something is there" : "the way is free");
    std::array<coppice::Hit, 16> hits;
    const std::size_t hit_count = scene.intersect_all(ray, hits);
    std::printf("%zu triangles along the ray\n", hit_count);

    // Many rays at once, on all threads.
    std::vector<coppice::Ray> rays(10'000, ray);
    for (std::size_t i = 0; i < rays.size(); ++i) {
        rays[i].origin.x = static_cast<float>(i % 100) / 50.0F - 1.0F;
        rays[i].origin.y = static_cast<float>(i / 100) / 50.0F - 1.0F;
    }
    std::vector<coppice::Hit> first(rays.size());
    scene.intersect(rays, first);

    // What is near a point, and whether the point is inside.
    const coppice::SurfaceNeighbor nearest = scene.nearest({1, 1, 1});
    std::printf("triangle %u is %.3f away\n", nearest.prim, nearest.distance());
    const coppice::SignedDistance surface = scene.make_signed_distance();
    const double depth = -surface.nearest({0, 0, 0}).signed_distance;
    std::printf("the origin is %.3f below the surface\n", depth);

    // A k-d tree from a tenth of the triangles.
    const auto [tree, sampled] =
        coppice::build_kd_tree(scene.mesh().view(), {.sample = {.rate = 0.1}});
    std::printf("%u of %u triangles chose the planes; SAH cost %.1f, %zu nodes\n",
                sampled.sample_count, sampled.primitive_count, sampled.statistics.sah_cost,
                tree.nodes().size());
}
