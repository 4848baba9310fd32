// The first program of a user: one triangle, one ray.
#include <coppice/coppice.h>

#include <cstdio>
#include <fstream>

int main() {
    std::ofstream("triangle.obj") << "v -1 -1 0\nv 1 -1 0\nv 0 1 0\nf 1 2 3\n";
    const coppice::Scene scene(coppice::load_mesh("triangle.obj"));
    const coppice::Ray ray{.origin = {0, 0, -5}, .direction = {0, 0, 1}};
    const auto hit = scene.intersect(ray);
    if (!hit || hit->t != 5) {
        std::fputs("the ray must hit the triangle at t = 5\n", stderr);
        return 1;
    }
    std::printf("triangle %u at t = %g\n", hit->prim, hit->t);
}
