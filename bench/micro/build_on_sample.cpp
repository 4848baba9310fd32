#include "coppice/builders/build_on_sample.h"

#include "terrain.h"

#include <benchmark/benchmark.h>

#include <string>

namespace coppice::bench {
namespace {

// Items are the primitives in the sample.
void build(benchmark::State& state, const std::string& rule) {
    const TriangleMeshView triangles = terrain().view();
    KdOptions options = options_at(state.range(0));
    options.split.rule = rule;
    const Sample sample = draw_sample(triangles, options.sample);
    for ([[maybe_unused]] const auto step : state) {
        benchmark::DoNotOptimize(build_on_sample(triangles, sample, options));
    }
    state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(sample.ids.size()));
}

BENCHMARK_CAPTURE(build, sah, std::string("sah"))
    ->ArgName("percent")
    ->Arg(1)
    ->Arg(10)
    ->Arg(100)
    ->UseRealTime()
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(build, median, std::string("median"))
    ->ArgName("percent")
    ->Arg(100)
    ->UseRealTime()
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(build, midpoint, std::string("midpoint"))
    ->ArgName("percent")
    ->Arg(100)
    ->UseRealTime()
    ->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace coppice::bench
