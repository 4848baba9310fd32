#include "coppice/base/memory_meter.h"
#include "coppice/base/parallel.h"
#include "coppice/build/build_tree.h"
#include "coppice/build/draw_sample.h"
#include "coppice/cost/measure.h"

#include "build/kernels/wide_kernels.h"
#include "build/stage_clock.h"
#include "build/wide/grow_wide.h"
#include "build/wide/make_references.h"

#include <utility>

namespace coppice {
namespace {

using wide::Reference;

wide::Top build_top(std::span<const Reference> references, const Sample& sample,
                    const BuildOptions& options, const wide::Kernels& kernels) {
    std::vector<Reference> sampled(sample.ids.size());
    for (std::size_t at = 0; at < sampled.size(); ++at) {
        sampled[at] = references[sample.ids[at]];
        sampled[at].weight = sample.weights.empty() ? static_cast<float>(references.size()) /
                                                          static_cast<float>(sample.ids.size())
                                                    : sample.weights[at];
    }
    return wide::build_object_top(sampled, static_cast<float>(options.wide.cell_size), kernels);
}

// The cells of the top, filled: one of everything where the scene is not sampled.
std::vector<wide::Range> make_cells(const wide::Arena& arena, const BuildOptions& options,
                                    const wide::Kernels& kernels, StageClock& clock,
                                    BuildReport& report, wide::Top& top) {
    const std::span<Reference> references = arena.first();
    SampleOptions sampling = options.sample;
    if (references.size() < options.wide.sampled_from) sampling.rate = 1.0;
    const auto count = static_cast<std::uint32_t>(references.size());
    report.sample_count = sample_count(count, sampling.rate);
    if (report.sample_count == count) {
        report.stages.sample = clock.lap(count);
        return {{.begin = 0, .end = count, .buffer = 0}};
    }
    const Sample sample = draw_sample(wide::ReferenceSet(references), sampling);
    report.stages.sample = clock.lap(sample.ids.size());
    top = build_top(references, sample, options, kernels);
    report.stages.build = clock.lap(top.nodes.size());
    std::vector<wide::Range> cells = wide::fill_cells(top, references, arena.second());
    report.stages.refill = clock.lap(count);
    return cells;
}

WideBvh run_pipeline(TriangleMeshView mesh, const BuildOptions& options, BuildReport& report) {
    StageClock clock;
    MemoryMeter meter;
    const wide::Kernels& kernels = wide::kernels_for(choose_isa());
    wide::Arena arena(mesh.size(), meter);
    wide::make_references(mesh, arena.first());

    wide::Top top;
    const auto unmeasured = make_cells(arena, options, kernels, clock, report, top);
    const std::vector<wide::Range> cells = wide::measure_cells(unmeasured, arena, kernels);
    wide::GrownTree grown = wide::grow_wide(top, cells, arena, kernels);
    const MeteredBytes part_bytes(&meter, byte_count(grown.root));
    WideBvh tree = wide::assemble(std::move(grown), std::move(arena), mesh, meter);
    report.stages.refine = clock.lap(mesh.size());
    report.peak_bytes = meter.peak_bytes();
    return tree;
}

}  // namespace

WideBvh build_wide_bvh(TriangleMeshView mesh, const BuildOptions& options, BuildReport* report) {
    check(options);
    BuildReport own_report;
    own_report.options = options;
    own_report.primitive_count = mesh.size();
    WideBvh tree;
    run_with_threads(options.threads, [&] { tree = run_pipeline(mesh, options, own_report); });
    if (report != nullptr) {
        own_report.tree_bytes = tree.byte_count();
        own_report.statistics = measure(tree, options.cost);
        *report = std::move(own_report);
    }
    return tree;
}

}  // namespace coppice
