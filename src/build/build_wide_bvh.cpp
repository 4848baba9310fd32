#include "coppice/base/memory_meter.h"
#include "coppice/base/parallel.h"
#include "coppice/build/build_on_sample.h"
#include "coppice/build/build_tree.h"
#include "coppice/build/draw_sample.h"
#include "coppice/build/empty_leaves.h"
#include "coppice/cost/measure.h"

#include "build/finite_boxes.h"
#include "build/kernels/wide_kernels.h"
#include "build/stage_clock.h"
#include "build/wide/grow_wide.h"
#include "build/wide/make_references.h"
#include "build/wide/plan.h"

#include <utility>

namespace coppice {
namespace {

using wide::Reference;

// What all stages of a build share.
struct Run {
    StageClock clock;
    MemoryMeter meter;
    const wide::Kernels& kernels;
    BuildReport& report;
};

wide::Top build_top(std::span<const Reference> references, const Sample& sample,
                    std::uint32_t cell_size, const wide::Kernels& kernels) {
    std::vector<Reference> sampled(sample.ids.size());
    for (std::size_t at = 0; at < sampled.size(); ++at) {
        sampled[at] = references[sample.ids[at]];
        sampled[at].weight = sample.weights.empty() ? static_cast<float>(references.size()) /
                                                          static_cast<float>(sample.ids.size())
                                                    : sample.weights[at];
    }
    return wide::build_object_top(sampled, static_cast<float>(cell_size), kernels);
}

// Cells by centroids; without a sample one cell of everything.
wide::Cells make_object_cells(TriangleMeshView mesh, const wide::Plan& plan, Run& run) {
    wide::Cells cells{{}, wide::Arena(mesh.size(), run.meter), {}};
    const std::span<Reference> references = cells.arena.first();
    wide::make_references(mesh, references);
    const std::uint32_t count = mesh.size();
    run.report.sample_count = sample_count(count, plan.sampling.rate);
    if (run.report.sample_count == count) {
        run.report.stages.sample = run.clock.lap(count);
        cells.ranges.push_back({.begin = 0, .end = count, .buffer = 0});
        return cells;
    }
    const Sample sample = draw_sample(wide::ReferenceSet(references), plan.sampling);
    run.report.sample_count = static_cast<std::uint32_t>(sample.ids.size());
    run.report.stages.sample = run.clock.lap(sample.ids.size());
    cells.top = build_top(references, sample, plan.cell_size, run.kernels);
    run.report.stages.build = run.clock.lap(cells.top.nodes.size());
    cells.ranges = wide::fill_cells(cells.top, references, cells.arena.second());
    run.report.stages.refill = run.clock.lap(count);
    return cells;
}

// Cells by planes: the first stages of a k-d tree.
wide::Cells make_kd_cells(TriangleMeshView mesh, const wide::Plan& plan, Run& run) {
    require_finite_boxes(mesh);
    const BuildOptions options{.sample = plan.sampling,
                               .split = {.rule = "binned",
                                         .max_leaf = plan.cell_size,
                                         .bad_refines = 1,
                                         .counting = Counting::expected},
                               .growth = Growth::none,
                               .cost = {.empty_bonus = 0.0}};
    const Sample sample = draw_sample(mesh, plan.sampling);
    run.report.sample_count = static_cast<std::uint32_t>(sample.ids.size());
    run.report.stages.sample = run.clock.lap(sample.ids.size());
    KdTree sampled = build_on_sample(mesh, sample, options, &run.meter);
    run.report.stages.build = run.clock.lap(sampled.nodes().size());
    const Skeleton skeleton = empty_leaves(std::move(sampled));
    run.report.stages.empty = run.clock.lap(skeleton.nodes().size());
    wide::Cells cells = wide::make_cells(skeleton, mesh, run.meter);
    run.report.stages.refill = run.clock.lap(cells.ranges.empty() ? 0 : cells.ranges.back().end);
    return cells;
}

WideBvh run_pipeline(TriangleMeshView mesh, const BuildOptions& options, BuildReport& report) {
    Run run{{}, {}, wide::kernels_for(choose_isa()), report};
    const wide::Plan plan = wide::make_plan(options, mesh.size());
    wide::Cells cells =
        plan.by_planes ? make_kd_cells(mesh, plan, run) : make_object_cells(mesh, plan, run);
    wide::measure_cells(cells, run.kernels);
    wide::GrownTree grown = wide::grow_wide(cells, run.kernels);
    const MeteredBytes part_bytes(&run.meter, byte_count(grown.root));
    WideBvh tree =
        wide::assemble(std::move(grown), std::move(cells.arena), mesh, run.kernels, run.meter);
    report.stages.refine = run.clock.lap(tree.blocks().size());
    report.peak_bytes = run.meter.peak_bytes();
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
