#include "query_points.h"

#include <benchmark/benchmark.h>

namespace coppice::bench {
namespace {

// Items are queries.
void triangles_within(benchmark::State& state) {
    const Scene& scene = terrain_scene();
    for ([[maybe_unused]] const auto step : state) {
        for (const Vec3f& point : query_points()) {
            std::size_t count = 0;
            scene.for_each_within(point, 0.03F, [&](const SurfaceNeighbor&) { ++count; });
            benchmark::DoNotOptimize(count);
        }
    }
    count_queries(state);
}

void points_within(benchmark::State& state) {
    const PointScene& scene = corner_scene();
    for ([[maybe_unused]] const auto step : state) {
        for (const Vec3f& point : query_points()) {
            std::size_t count = 0;
            scene.for_each_within(point, 0.03F, [&](const Neighbor&) { ++count; });
            benchmark::DoNotOptimize(count);
        }
    }
    count_queries(state);
}

BENCHMARK(triangles_within)->Unit(benchmark::kMillisecond);
BENCHMARK(points_within)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace coppice::bench
