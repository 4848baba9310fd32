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

WideBvh run_pipeline(TriangleMeshView mesh, const BuildOptions& options, BuildReport& report) {
    StageClock clock;
    StageReports& stages = report.stages;
    MemoryMeter meter;
    const wide::Kernels& kernels = wide::kernels_for(choose_isa());
    wide::Arena arena(mesh.size());
    const MeteredBytes arena_bytes(&meter, arena.byte_count());
    const std::span<Reference> references = arena.first();
    const std::span<Reference> buffer = arena.second();
    wide::make_references(mesh, references);

    wide::Top top;
    std::vector<wide::Range> cells;
    SampleOptions sampling = options.sample;
    if (mesh.size() < options.wide.sampled_from) sampling.rate = 1.0;
    report.sample_count = mesh.size();
    if (sampling.rate < 1.0) {
        const Sample sample = draw_sample(wide::ReferenceSet(references), sampling);
        report.sample_count = static_cast<std::uint32_t>(sample.ids.size());
        stages.sample = clock.lap(sample.ids.size());
        const MeteredBytes sample_bytes(
            &meter, sample.ids.size() * (2 * sizeof(Reference) + sizeof(sample.ids[0])));
        top = build_top(references, sample, options, kernels);
        stages.build = clock.lap(top.nodes.size());
        cells = wide::fill_cells(top, references, buffer);
        stages.refill = clock.lap(mesh.size());
    } else {
        cells.push_back({.begin = 0, .end = mesh.size(), .buffer = 0});
    }
    const wide::Splitter measurer(references, buffer, {}, kernels);
    wide::Box8 bounds = wide::Box8::make_empty();
    parallel_for_chunks(cells.size(), 1, [&](std::size_t cell, std::size_t /*end*/) {
        cells[cell] = measurer.measured(cells[cell].begin, cells[cell].end, cells[cell].buffer);
    });
    for (const wide::Range& cell : cells)
        bounds.grow(cell.box);
    const wide::Splitter splitter(references, buffer, {8.0F, true, wide::extent_factor_of(bounds)},
                                  kernels);
    wide::GrownTree grown = wide::grow_wide(top, cells, splitter, arena.ids());
    WideBvh tree = wide::assemble(std::move(grown), std::move(arena), mesh);
    stages.refine = clock.lap(mesh.size());
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
