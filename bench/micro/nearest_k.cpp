#include "query_points.h"

#include <benchmark/benchmark.h>

#include <vector>

namespace coppice::bench {
namespace {

// Items are queries.
void nearest_k_triangles(benchmark::State& state) {
    const Scene& scene = terrain_scene();
    std::vector<SurfaceNeighbor> found(static_cast<std::size_t>(state.range(0)));
    for ([[maybe_unused]] const auto step : state) {
        for (const Vec3f& point : query_points()) {
            benchmark::DoNotOptimize(scene.nearest_k(point, found));
        }
    }
    count_queries(state);
}

void nearest_k_points(benchmark::State& state) {
    const PointScene& scene = corner_scene();
    std::vector<Neighbor> found(static_cast<std::size_t>(state.range(0)));
    for ([[maybe_unused]] const auto step : state) {
        for (const Vec3f& point : query_points()) {
            benchmark::DoNotOptimize(scene.nearest_k(point, found));
        }
    }
    count_queries(state);
}

BENCHMARK(nearest_k_triangles)->ArgName("k")->Arg(8)->Arg(64)->Unit(benchmark::kMillisecond);
BENCHMARK(nearest_k_points)->ArgName("k")->Arg(8)->Arg(64)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace coppice::bench
