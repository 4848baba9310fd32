#include "coppice/geom/triangle.h"

#include "rays.h"

#include <benchmark/benchmark.h>

namespace coppice::bench {
namespace {

// Items are single tests of a ray with a triangle, few of which hit.
void one_triangle(benchmark::State& state) {
    const TriangleMeshView triangles = terrain().view();
    std::uint32_t id = 0;
    run_rays(state, [&](const Ray& ray) {
        id = id + 1 == triangles.size() ? 0 : id + 1;
        return intersect_triangle(ray, triangles.triangle(id));
    });
}

BENCHMARK(one_triangle)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace coppice::bench
