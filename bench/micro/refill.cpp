#include "coppice/builders/refill.h"

#include "terrain.h"

#include <benchmark/benchmark.h>

#include <utility>

namespace coppice::bench {
namespace {

// Items are all primitives.
void fill(benchmark::State& state) {
    const TriangleMeshView triangles = terrain().view();
    const KdOptions options = options_at(state.range(0));
    const Skeleton skeleton = empty_leaves(sampled_tree(options));
    for ([[maybe_unused]] const auto step : state) {
        state.PauseTiming();
        Skeleton copy = skeleton;
        state.ResumeTiming();
        benchmark::DoNotOptimize(refill(std::move(copy), triangles, options));
    }
    state.SetItemsProcessed(state.iterations() * triangles.size());
}

BENCHMARK(fill)->ArgName("percent")->Arg(1)->Arg(10)->Arg(100)->UseRealTime()->Unit(
    benchmark::kMillisecond);

}  // namespace
}  // namespace coppice::bench
