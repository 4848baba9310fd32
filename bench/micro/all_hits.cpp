#include "coppice/trace/intersect.h"

#include "rays.h"

#include <benchmark/benchmark.h>

#include <array>
#include <vector>

namespace coppice::bench {
namespace {

void all_hits_kd(benchmark::State& state) {
    run_rays_kd(state, [](const KdTree& tree, const Ray& ray) {
        std::array<Hit, 4> hits;
        return intersect_all(tree, terrain().view(), ray, hits);
    });
}

void all_hits_bvh8(benchmark::State& state) {
    run_rays_bvh8(state, [](const Bvh8Tracer& tracer, const Ray& ray) {
        std::array<Hit, 4> hits;
        return tracer.intersect_all(ray, hits);
    });
}

void all_hits_batch(benchmark::State& state) {
    std::vector<Hit> hits(4 * rays().size());
    std::vector<std::size_t> counts(rays().size());
    run_batch(state, [&](const Bvh8Tracer& tracer, int threads) {
        tracer.intersect_all(rays(), hits, counts, threads);
    });
}

BENCHMARK(all_hits_kd)->Apply(on_samples);
BENCHMARK(all_hits_bvh8)->Unit(benchmark::kMillisecond);
BENCHMARK(all_hits_batch)->Apply(on_threads);

}  // namespace
}  // namespace coppice::bench
