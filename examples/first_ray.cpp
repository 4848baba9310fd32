#include <coppice/coppice.h>

#include <cmath>
#include <cstdint>
#include <cstdio>

// A hilly landscape over the unit square: 2 x side x side triangles.
coppice::TriangleMesh make_hills(std::uint32_t side) {
    coppice::TriangleMesh mesh;
    for (std::uint32_t j = 0; j <= side; ++j) {
        for (std::uint32_t i = 0; i <= side; ++i) {
            const float x = static_cast<float>(i) / static_cast<float>(side);
            const float y = static_cast<float>(j) / static_cast<float>(side);
            mesh.vertices.push_back({x, y, 0.1F * std::sin(20 * x) * std::sin(20 * y)});
            if (i == side || j == side) continue;
            const std::uint32_t corner = j * (side + 1) + i;
            mesh.triangles.push_back({corner, corner + 1, corner + side + 1});
            mesh.triangles.push_back({corner + 1, corner + side + 2, corner + side + 1});
        }
    }
    return mesh;
}

int main() {
    // A tree over half a million triangles, built from one in a hundred of them.
    const coppice::Scene scene(make_hills(512), {.sample = {.rate = 0.01}});
    const coppice::BuildReport& report = scene.build_report();
    std::printf("%u triangles, %u of them sampled, tree built in %.3f s\n", report.primitive_count,
                report.sample_count, report.stages.wall_seconds());

    // The first thing straight below a point high above, and what is nearest to that point.
    if (const auto hit = scene.intersect({.origin = {0.4F, 0.4F, 2}, .direction = {0, 0, -1}})) {
        std::printf("a ray down hits triangle %u at t = %g\n", hit->prim, hit->t);
    }
    const coppice::SurfaceNeighbor nearest = scene.nearest({0.4F, 0.4F, 2});
    std::printf("triangle %u is nearest, %g away\n", nearest.prim, nearest.distance());
}
