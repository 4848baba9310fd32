#include "coppice/builders/build_tree.h"
#include "coppice/builders/method.h"

#include "terrain.h"

#include <benchmark/benchmark.h>

#include <string>

namespace coppice::bench {
namespace {

// Items are triangles; the cost of the tree stands beside.
void build(benchmark::State& state, const std::string& method) {
    const TriangleMeshView triangles = terrain().view();
    const KdOptions options = find_method(method).kd_options();
    BuildReport report;
    for ([[maybe_unused]] const auto step : state) {
        KdBuild built = build_kd_tree(triangles, options);
        benchmark::DoNotOptimize(built);
        report = std::move(built.report);
    }
    state.SetItemsProcessed(state.iterations() * triangles.size());
    state.counters["sah_cost"] = report.statistics.sah_cost;
}

BENCHMARK_CAPTURE(build, exact, std::string("exact"))->UseRealTime()->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(build, binned, std::string("binned"))
    ->UseRealTime()
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(build, sampled, std::string("sampled"))
    ->UseRealTime()
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(build, subsampled, std::string("subsampled"))
    ->UseRealTime()
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(build, adaptive, std::string("adaptive"))
    ->UseRealTime()
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(build, sweep, std::string("sweep"))->UseRealTime()->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace coppice::bench
