// What lies near a point: on a mesh, and among points.
#include <coppice/coppice.h>

#include <array>
#include <cstdio>

int main() {
    const coppice::Scene scene(coppice::load_mesh("bunny.obj"));
    const coppice::Vec3f point{0.5F, 0.5F, 0.5F};

    const coppice::SurfaceNeighbor nearest = scene.nearest(point);
    std::printf("nearest: (%.3f, %.3f, %.3f) on triangle %u, %.3f away\n", nearest.point.x,
                nearest.point.y, nearest.point.z, nearest.prim, nearest.distance());

    // The bunny is closed, so a point is inside or outside of it.
    const coppice::SignedDistance surface = scene.make_signed_distance();
    std::printf("the origin is %s\n",
                surface.nearest({0, 0, 0}).signed_distance < 0.0 ? "inside" : "outside");

    int count = 0;
    scene.for_each_within(point, 0.5F, [&](const coppice::SurfaceNeighbor&) { ++count; });
    scene.for_each_overlapping({{0, 0, 0}, point}, [&](std::uint32_t) { ++count; });
    std::printf("%d triangles within 0.5, or in the box to the origin\n", count);

    // The same questions asked of points; spans take the results, nothing is allocated.
    const coppice::PointScene corners(scene.mesh().vertices);
    std::array<coppice::Neighbor, 3> found;
    const std::size_t found_count = corners.nearest_k(point, found);
    for (const coppice::Neighbor& corner : std::span(found).first(found_count)) {
        std::printf("corner %u, %.3f away\n", corner.prim, corner.distance());
    }
}
