#include "coppice/builders/draw_sample.h"

#include "terrain.h"

#include <benchmark/benchmark.h>

#include <string>

namespace coppice::bench {
namespace {

// Items are the primitives to choose from.
void draw(benchmark::State& state, const std::string& sampler) {
    const TriangleMeshView triangles = terrain().view();
    SampleOptions options = options_at(state.range(0)).sample;
    options.sampler = sampler;
    for ([[maybe_unused]] const auto step : state) {
        benchmark::DoNotOptimize(draw_sample(triangles, options));
    }
    state.SetItemsProcessed(state.iterations() * triangles.size());
}

BENCHMARK_CAPTURE(draw, uniform, std::string("uniform"))
    ->ArgName("percent")
    ->Arg(1)
    ->Arg(10)
    ->Arg(50)
    ->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace coppice::bench
