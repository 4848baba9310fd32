#include "coppice/trace/intersect.h"

#include "rays.h"

#include <benchmark/benchmark.h>

#include <vector>

namespace coppice::bench {
namespace {

void closest_hit_kd(benchmark::State& state) {
    const KdTree tree = kd_tree_at(state.range(0));
    run_rays(state, [&](const Ray& ray) { return intersect(tree, terrain().view(), ray); });
}

void closest_hit_wide(benchmark::State& state) {
    run_rays(state, [](const Ray& ray) { return wide_tracer().intersect(ray); });
}

void closest_hit_batch(benchmark::State& state) {
    std::vector<Hit> hits(rays().size());
    const auto threads = static_cast<int>(state.range(0));
    run_batch(state, [&] { wide_tracer().intersect(rays(), hits, threads); });
}

BENCHMARK(closest_hit_kd)->ArgName("percent")->Arg(1)->Arg(100)->Unit(benchmark::kMillisecond);
BENCHMARK(closest_hit_wide)->Unit(benchmark::kMillisecond);
BENCHMARK(closest_hit_batch)
    ->ArgName("threads")
    ->Arg(1)
    ->Arg(2)
    ->UseRealTime()
    ->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace coppice::bench
