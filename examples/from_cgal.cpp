// What a program that used CGAL's AABB tree and spatial searching does with coppice.
#include <coppice/coppice.h>

#include <array>
#include <cstdio>
#include <span>

int main() {
    // AABB_tree tree(faces(mesh).first, faces(mesh).second, mesh)
    const coppice::Scene scene(coppice::load_mesh("bunny.obj"));
    const coppice::Ray ray{.origin = {0, 0, -5}, .direction = {0, 0, 1}};

    // do_intersect, number_of_intersected_primitives
    std::printf("%s, %llu triangles\n", scene.occluded(ray) ? "hit" : "missed",
                static_cast<unsigned long long>(scene.count_hits(ray)));

    // first_intersection
    if (const auto hit = scene.intersect(ray)) std::printf("first: triangle %u\n", hit->prim);

    // all_intersections: in order, some at a time
    std::array<coppice::Hit, 4> hits;
    std::size_t count = scene.intersect_all(ray, hits);
    while (count > 0) {
        for (const coppice::Hit& hit : std::span(hits).first(count))
            std::printf("t = %g\n", hit.t);
        count = count == hits.size() ? scene.intersect_all(ray, hits, &hits.back()) : 0;
    }

    // closest_point_and_primitive, squared_distance
    const coppice::SurfaceNeighbor nearest = scene.nearest({1, 1, 1});
    std::printf("triangle %u at squared distance %g\n", nearest.prim, nearest.distance_squared);

    // Side_of_triangle_mesh
    const coppice::SignedDistance surface = scene.make_signed_distance();
    const bool is_inside = surface.nearest({0, 0, 0}).signed_distance < 0.0;
    std::printf("the origin is %s\n", is_inside ? "inside" : "outside");

    // Orthogonal_k_neighbor_search, Fuzzy_sphere
    const coppice::PointScene points(scene.mesh().vertices);
    std::array<coppice::Neighbor, 8> neighbors;
    std::printf("%zu nearest points\n", points.nearest_k({1, 1, 1}, neighbors));
    int within = 0;
    points.for_each_within({1, 1, 1}, 1.0F, [&](const coppice::Neighbor&) { ++within; });
    std::printf("%d points within 1\n", within);
}
