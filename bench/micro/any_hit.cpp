#include "coppice/trace/intersect.h"

#include "rays.h"

#include <benchmark/benchmark.h>

#include <cstdint>
#include <vector>

namespace coppice::bench {
namespace {

void any_hit_kd(benchmark::State& state) {
    run_rays_kd(state, [](const KdTree& tree, const Ray& ray) {
        return occluded(tree, terrain().view(), ray);
    });
}

void any_hit_bvh8(benchmark::State& state) {
    run_rays_bvh8(state,
                  [](const Bvh8Tracer& tracer, const Ray& ray) { return tracer.occluded(ray); });
}

void any_hit_batch(benchmark::State& state) {
    std::vector<std::uint8_t> is_occluded(rays().size());
    run_batch(state, [&](const Bvh8Tracer& tracer, int threads) {
        tracer.occluded(rays(), is_occluded, threads);
    });
}

BENCHMARK(any_hit_kd)->Apply(on_samples);
BENCHMARK(any_hit_bvh8)->Unit(benchmark::kMillisecond);
BENCHMARK(any_hit_batch)->Apply(on_threads);

}  // namespace
}  // namespace coppice::bench
