#include "coppice/trace/intersect.h"

#include "rays.h"

#include <benchmark/benchmark.h>

#include <vector>

namespace coppice::bench {
namespace {

void count_hits_kd(benchmark::State& state) {
    const KdTree tree = kd_tree_at(state.range(0));
    run_rays(state, [&](const Ray& ray) { return count_hits(tree, terrain().view(), ray); });
}

void count_hits_wide(benchmark::State& state) {
    run_rays(state, [](const Ray& ray) { return wide_tracer().count_hits(ray); });
}

void count_hits_batch(benchmark::State& state) {
    std::vector<std::uint64_t> counts(rays().size());
    const auto threads = static_cast<int>(state.range(0));
    run_batch(state, [&] { wide_tracer().count_hits(rays(), counts, threads); });
}

BENCHMARK(count_hits_kd)->ArgName("percent")->Arg(1)->Arg(100)->Unit(benchmark::kMillisecond);
BENCHMARK(count_hits_wide)->Unit(benchmark::kMillisecond);
BENCHMARK(count_hits_batch)
    ->ArgName("threads")
    ->Arg(1)
    ->Arg(2)
    ->UseRealTime()
    ->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace coppice::bench
