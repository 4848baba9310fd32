#include "query_points.h"

#include <benchmark/benchmark.h>

#include <vector>

namespace coppice::bench {
namespace {

// Items are queries.
void nearest_triangle(benchmark::State& state) {
    const Scene& scene = terrain_scene();
    for ([[maybe_unused]] const auto step : state) {
        for (const Vec3f& point : query_points()) {
            benchmark::DoNotOptimize(scene.nearest(point));
        }
    }
    count_queries(state);
}

void nearest_point(benchmark::State& state) {
    const PointScene& scene = corner_scene();
    for ([[maybe_unused]] const auto step : state) {
        for (const Vec3f& point : query_points()) {
            benchmark::DoNotOptimize(scene.nearest(point));
        }
    }
    count_queries(state);
}

// On several threads at once.
void nearest_triangle_batch(benchmark::State& state) {
    const Scene& scene = terrain_scene();
    std::vector<SurfaceNeighbor> found(query_points().size());
    for ([[maybe_unused]] const auto step : state) {
        scene.search().nearest(query_points(), found, MeshSearch::anywhere,
                               static_cast<int>(state.range(0)));
        benchmark::ClobberMemory();
    }
    count_queries(state);
}

BENCHMARK(nearest_triangle)->Unit(benchmark::kMillisecond);
BENCHMARK(nearest_point)->Unit(benchmark::kMillisecond);
BENCHMARK(nearest_triangle_batch)
    ->ArgName("threads")
    ->Arg(1)
    ->Arg(2)
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();

}  // namespace
}  // namespace coppice::bench
