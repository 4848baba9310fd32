#include "coppice/cost/measure.h"

#include "coppice/builders/build_tree.h"

#include "terrain.h"

#include <benchmark/benchmark.h>

namespace coppice::bench {
namespace {

// Items are the tree's nodes.
void measure_tree(benchmark::State& state) {
    const KdTree tree = build_kd_tree(terrain().view()).tree;
    for ([[maybe_unused]] const auto step : state) {
        benchmark::DoNotOptimize(measure(tree, SahCostModel{}));
    }
    state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(tree.nodes().size()));
}

BENCHMARK(measure_tree)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace coppice::bench
