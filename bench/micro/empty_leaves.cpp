#include "coppice/builders/empty_leaves.h"

#include "terrain.h"

#include <benchmark/benchmark.h>

#include <utility>

namespace coppice::bench {
namespace {

// Items are the tree's nodes.
void empty(benchmark::State& state) {
    const KdTree tree = sampled_tree(options_at(state.range(0)));
    for ([[maybe_unused]] const auto step : state) {
        state.PauseTiming();
        KdTree copy = tree;
        state.ResumeTiming();
        benchmark::DoNotOptimize(empty_leaves(std::move(copy)));
    }
    state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(tree.nodes().size()));
}

BENCHMARK(empty)->ArgName("percent")->Arg(1)->Arg(10)->Arg(100)->Unit(benchmark::kMicrosecond);

}  // namespace
}  // namespace coppice::bench
