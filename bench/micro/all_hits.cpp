#include "coppice/trace/intersect.h"

#include "rays.h"

#include <benchmark/benchmark.h>

#include <array>
#include <vector>

namespace coppice::bench {
namespace {

void all_hits_kd(benchmark::State& state) {
    const KdTree tree = kd_tree_at(state.range(0));
    run_rays(state, [&](const Ray& ray) {
        std::array<Hit, 4> hits;
        return intersect_all(tree, terrain().view(), ray, hits);
    });
}

void all_hits_wide(benchmark::State& state) {
    run_rays(state, [](const Ray& ray) {
        std::array<Hit, 4> hits;
        return wide_tracer().intersect_all(ray, hits);
    });
}

void all_hits_batch(benchmark::State& state) {
    std::vector<Hit> hits(4 * rays().size());
    std::vector<std::size_t> counts(rays().size());
    const auto threads = static_cast<int>(state.range(0));
    run_batch(state, [&] { wide_tracer().intersect_all(rays(), hits, counts, threads); });
}

BENCHMARK(all_hits_kd)->ArgName("percent")->Arg(1)->Arg(100)->Unit(benchmark::kMillisecond);
BENCHMARK(all_hits_wide)->Unit(benchmark::kMillisecond);
BENCHMARK(all_hits_batch)
    ->ArgName("threads")
    ->Arg(1)
    ->Arg(2)
    ->UseRealTime()
    ->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace coppice::bench
