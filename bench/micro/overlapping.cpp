#include "query_points.h"

#include <benchmark/benchmark.h>

namespace coppice::bench {
namespace {

// Items are queries.
Aabb box_at(Vec3f point) {
    return {point, point + Vec3f{0.03F, 0.03F, 0.03F}};
}

void triangles_overlapping(benchmark::State& state) {
    const Scene& scene = terrain_scene();
    for ([[maybe_unused]] const auto step : state) {
        for (const Vec3f& point : query_points()) {
            std::size_t count = 0;
            scene.for_each_overlapping(box_at(point), [&](std::uint32_t) { ++count; });
            benchmark::DoNotOptimize(count);
        }
    }
    count_queries(state);
}

void points_overlapping(benchmark::State& state) {
    const PointScene& scene = corner_scene();
    for ([[maybe_unused]] const auto step : state) {
        for (const Vec3f& point : query_points()) {
            std::size_t count = 0;
            scene.for_each_overlapping(box_at(point), [&](std::uint32_t) { ++count; });
            benchmark::DoNotOptimize(count);
        }
    }
    count_queries(state);
}

BENCHMARK(triangles_overlapping)->Unit(benchmark::kMillisecond);
BENCHMARK(points_overlapping)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace coppice::bench
