#include "coppice/trace/intersect.h"

#include "rays.h"

#include <benchmark/benchmark.h>

#include <vector>

namespace coppice::bench {
namespace {

void closest_hit_kd(benchmark::State& state) {
    run_rays_kd(state, [](const KdTree& tree, const Ray& ray) {
        return intersect(tree, terrain().view(), ray);
    });
}

void closest_hit_bvh8(benchmark::State& state) {
    run_rays_bvh8(state,
                  [](const Bvh8Tracer& tracer, const Ray& ray) { return tracer.intersect(ray); });
}

void closest_hit_batch(benchmark::State& state) {
    std::vector<Hit> hits(rays().size());
    run_batch(state, [&](const Bvh8Tracer& tracer, int threads) {
        tracer.intersect(rays(), hits, threads);
    });
}

BENCHMARK(closest_hit_kd)->Apply(on_samples);
BENCHMARK(closest_hit_bvh8)->Unit(benchmark::kMillisecond);
BENCHMARK(closest_hit_batch)->Apply(on_threads);

}  // namespace
}  // namespace coppice::bench
