#include "coppice/trace/intersect.h"

#include "rays.h"

#include <benchmark/benchmark.h>

#include <vector>

namespace coppice::bench {
namespace {

void count_hits_kd(benchmark::State& state) {
    run_rays_kd(state, [](const KdTree& tree, const Ray& ray) {
        return count_hits(tree, terrain().view(), ray);
    });
}

void count_hits_bvh8(benchmark::State& state) {
    run_rays_bvh8(state,
                  [](const Bvh8Tracer& tracer, const Ray& ray) { return tracer.count_hits(ray); });
}

void count_hits_batch(benchmark::State& state) {
    std::vector<std::size_t> counts(rays().size());
    run_batch(state, [&](const Bvh8Tracer& tracer, int threads) {
        tracer.count_hits(rays(), counts, threads);
    });
}

BENCHMARK(count_hits_kd)->Apply(on_samples);
BENCHMARK(count_hits_bvh8)->Unit(benchmark::kMillisecond);
BENCHMARK(count_hits_batch)->Apply(on_threads);

}  // namespace
}  // namespace coppice::bench
