#include "coppice/trace/intersect.h"

#include "rays.h"

#include <benchmark/benchmark.h>

#include <memory>

namespace coppice::bench {
namespace {

void any_hit_kd(benchmark::State& state) {
    const KdTree tree = kd_tree_at(state.range(0));
    run_rays(state, [&](const Ray& ray) { return occluded(tree, terrain().view(), ray); });
}

void any_hit_wide(benchmark::State& state) {
    run_rays(state, [](const Ray& ray) { return wide_tracer().occluded(ray); });
}

void any_hit_batch(benchmark::State& state) {
    const auto is_occluded = std::make_unique<bool[]>(rays().size());
    const auto threads = static_cast<int>(state.range(0));
    run_batch(state, [&] {
        wide_tracer().occluded(rays(), {is_occluded.get(), rays().size()}, threads);
    });
}

BENCHMARK(any_hit_kd)->ArgName("percent")->Arg(1)->Arg(100)->Unit(benchmark::kMillisecond);
BENCHMARK(any_hit_wide)->Unit(benchmark::kMillisecond);
BENCHMARK(any_hit_batch)
    ->ArgName("threads")
    ->Arg(1)
    ->Arg(2)
    ->UseRealTime()
    ->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace coppice::bench
