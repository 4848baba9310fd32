#include "coppice/tree/validate.h"

#include "coppice/builders/build_tree.h"

#include "terrain.h"

#include <benchmark/benchmark.h>

namespace coppice::bench {
namespace {

// Items are the primitives.
void validate_tree(benchmark::State& state) {
    const TriangleMeshView triangles = terrain().view();
    const KdTree tree = build_kd_tree(triangles).tree;
    for ([[maybe_unused]] const auto step : state) {
        const auto findings = validate(tree, triangles);
        if (!findings.empty()) state.SkipWithError(findings.front().message.c_str());
    }
    state.SetItemsProcessed(state.iterations() * triangles.size());
}

BENCHMARK(validate_tree)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace coppice::bench
