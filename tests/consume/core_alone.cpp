// A user of coppice::core: a tree over a triangle of the program's own, and one ray.
#include <coppice/scene/scene.h>
#include <coppice/version.h>

#include <cstdio>
#include <utility>

int main() {
    coppice::TriangleMesh mesh;
    mesh.vertices = {{-1, -1, 0}, {1, -1, 0}, {0, 1, 0}};
    mesh.triangles = {{0, 1, 2}};
    const coppice::Scene scene(std::move(mesh));
    const coppice::Ray ray{.origin = {0, 0, -5}, .direction = {0, 0, 1}};
    const auto hit = scene.intersect(ray);
    if (!hit || hit->t != 5) {
        std::fputs("the ray must hit the triangle at t = 5\n", stderr);
        return 1;
    }
    std::printf("coppice %s: triangle %u at t = %g\n", coppice::version().text, hit->prim, hit->t);
}
