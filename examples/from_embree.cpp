// What a program that used Embree does with coppice: a mesh from its own arrays, single rays,
// shadow rays, rays by the thousand, hits in order, and the nearest point of the surface.
#include <coppice/coppice.h>

#include <array>
#include <cstdio>
#include <utility>
#include <vector>

int main() {
    // rtcSetNewGeometryBuffer, rtcAttachGeometry, rtcCommitScene
    coppice::TriangleMesh mesh;
    mesh.vertices = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {1, 0, 1}, {0, 1, 1}};
    mesh.triangles = {{0, 1, 2}, {3, 4, 5}};
    const coppice::Scene scene(std::move(mesh));

    // rtcIntersect1
    const coppice::Ray ray{.origin = {0.25F, 0.25F, 2}, .direction = {0, 0, -1}};
    if (const auto hit = scene.intersect(ray)) {
        std::printf("triangle %u at t = %g, normal (%g, %g, %g)\n", hit->prim, hit->t,
                    hit->normal.x, hit->normal.y, hit->normal.z);
    }

    // rtcOccluded1
    const coppice::Ray shadow{
        .origin = {0.25F, 0.25F, 0.5F}, .direction = {0, 0, 1}, .t_max = 0.4F};
    std::printf("the light is %s\n", scene.occluded(shadow) ? "hidden" : "seen");

    // rtcIntersect1M
    const std::vector<coppice::Ray> rays(1000, ray);
    std::vector<coppice::Hit> hits(rays.size());
    scene.intersect(rays, hits);  // on all threads

    // An intersection filter that collects hits
    std::array<coppice::Hit, 8> first;
    const std::size_t count = scene.intersect_all(ray, first);
    std::printf("%zu hits, the last at t = %g\n", count, first[count - 1].t);

    // rtcPointQuery
    const coppice::SurfaceNeighbor nearest = scene.nearest({0.25F, 0.25F, 0.75F});
    std::printf("triangle %u is %g away\n", nearest.prim, nearest.distance());
}
