#include "coppice/builders/refine.h"

#include "terrain.h"

#include <benchmark/benchmark.h>

#include <utility>

namespace coppice::bench {
namespace {

// Items are all primitives.
void grow(benchmark::State& state) {
    const TriangleMeshView triangles = terrain().view();
    const KdOptions options = options_at(state.range(0));
    const KdTree tree = refilled_tree(options);
    for ([[maybe_unused]] const auto step : state) {
        state.PauseTiming();
        KdTree copy = tree;
        state.ResumeTiming();
        benchmark::DoNotOptimize(grow_kd(std::move(copy), triangles, options));
    }
    state.SetItemsProcessed(state.iterations() * triangles.size());
}

BENCHMARK(grow)->ArgName("percent")->Arg(1)->Arg(10)->Arg(100)->UseRealTime()->Unit(
    benchmark::kMillisecond);

}  // namespace
}  // namespace coppice::bench
