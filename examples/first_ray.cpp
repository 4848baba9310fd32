#include <coppice/coppice.h>

#include <cstdio>

int main() {
    const coppice::Scene scene(coppice::load_mesh("bunny.obj"), {.sample = {.rate = 0.05}});
    const coppice::Ray ray{.origin = {0, 0, -5}, .direction = {0, 0, 1}};
    if (const auto hit = scene.intersect(ray)) {
        std::printf("triangle %u at t = %g\n", hit->prim, hit->t);
    }
}
