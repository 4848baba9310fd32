#include "coppice/base/memory_meter.h"
#include "coppice/base/parallel.h"
#include "coppice/build/build_on_sample.h"
#include "coppice/build/build_tree.h"
#include "coppice/build/draw_sample.h"
#include "coppice/build/empty_leaves.h"
#include "coppice/build/refill.h"
#include "coppice/cost/measure.h"

#include "build/finite_boxes.h"
#include "build/kernels/wide_kernels.h"
#include "build/stage_clock.h"
#include "build/wide/grow_wide.h"
#include "build/wide/make_references.h"

#include <algorithm>
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

// What a preset stands for.
struct Plan {
    bool by_planes;
    std::uint32_t cell_size;
    double least_rate;  // of the sample
};

// Rays a triangle that make up for a longer build: extra build time a triangle over what a ray gains
// by it (docs/decisions/0005).
constexpr double balanced_from = 20.0;
constexpr double quality_from = 100.0;

WidePreset choose_preset(const WideOptions& options, std::size_t triangle_count) {
    if (options.preset != WidePreset::automatic) return options.preset;
    const double rays_a_triangle =
        options.expected_rays / static_cast<double>(std::max<std::size_t>(1, triangle_count));
    if (rays_a_triangle >= quality_from) return WidePreset::quality;
    return rays_a_triangle >= balanced_from ? WidePreset::balanced : WidePreset::fast;
}

Plan make_plan(const WideOptions& options, std::size_t triangle_count) {
    Plan plan{false, 4096, 0.0};
    switch (choose_preset(options, triangle_count)) {
        case WidePreset::automatic:
        case WidePreset::fast:
            break;
        case WidePreset::balanced:
            plan = {true, 32768, 0.0};
            break;
        case WidePreset::quality:
            plan = {true, 512, 0.1};
            break;
    }
    if (options.cell_size != 0) plan.cell_size = options.cell_size;
    return plan;
}

// The options of the sample that the top is chosen from; rate 1 where there is none.
SampleOptions sampling_of(const BuildOptions& options, const Plan& plan,
                          std::size_t triangle_count) {
    SampleOptions sampling = options.sample;
    const bool is_automatic = options.wide.preset == WidePreset::automatic;
    if (is_automatic && sampling.rate == 1.0) sampling = {.rate = 0.01, .sampler = "weighted"};
    sampling.rate = std::max(sampling.rate, plan.least_rate);
    if (triangle_count < options.wide.sampled_from) sampling.rate = 1.0;
    return sampling;
}

wide::Top build_top(std::span<const Reference> references, const Sample& sample,
                    std::uint32_t cell_size, const wide::Kernels& kernels) {
    std::vector<Reference> sampled(sample.ids.size());
    for (std::size_t at = 0; at < sampled.size(); ++at) {
        sampled[at] = references[sample.ids[at]];
        sampled[at].weight = sample.weights.empty()
                                 ? static_cast<float>(references.size()) /
                                       static_cast<float>(sample.ids.size())
                                 : sample.weights[at];
    }
    return wide::build_object_top(sampled, static_cast<float>(cell_size), kernels);
}

// Cells by centroids; without a sample one cell of everything.
wide::Cells make_object_cells(TriangleMeshView mesh, const SampleOptions& sampling,
                              std::uint32_t cell_size, Run& run) {
    wide::Cells cells{{}, wide::Arena(mesh.size(), run.meter), {}};
    const std::span<Reference> references = cells.arena.first();
    wide::make_references(mesh, references);
    const std::uint32_t count = mesh.size();
    run.report.sample_count = sample_count(count, sampling.rate);
    if (run.report.sample_count == count) {
        run.report.stages.sample = run.clock.lap(count);
        cells.ranges.push_back({.begin = 0, .end = count, .buffer = 0});
        return cells;
    }
    const Sample sample = draw_sample(wide::ReferenceSet(references), sampling);
    run.report.sample_count = static_cast<std::uint32_t>(sample.ids.size());
    run.report.stages.sample = run.clock.lap(sample.ids.size());
    cells.top = build_top(references, sample, cell_size, run.kernels);
    run.report.stages.build = run.clock.lap(cells.top.nodes.size());
    cells.ranges = wide::fill_cells(cells.top, references, cells.arena.second());
    run.report.stages.refill = run.clock.lap(count);
    return cells;
}

// Cells by planes: the first stages of a k-d tree.
wide::Cells make_kd_cells(TriangleMeshView mesh, const SampleOptions& sampling,
                          std::uint32_t cell_size, Run& run) {
    require_finite_boxes(mesh);
    BuildOptions options{.sample = sampling,
                         .split = {.rule = "binned",
                                   .max_leaf = cell_size,
                                   .bad_refines = 1,
                                   .counting = Counting::expected},
                         .growth = Growth::none,
                         .cost = {.empty_bonus = 0.0}};
    const Sample sample = draw_sample(mesh, sampling);
    run.report.sample_count = static_cast<std::uint32_t>(sample.ids.size());
    run.report.stages.sample = run.clock.lap(sample.ids.size());
    KdTree sampled = build_on_sample(mesh, sample, options, &run.meter);
    run.report.stages.build = run.clock.lap(sampled.nodes().size());
    Skeleton skeleton = empty_leaves(std::move(sampled));
    run.report.stages.empty = run.clock.lap(skeleton.nodes().size());
    const KdTree refilled = refill(std::move(skeleton), mesh, options, &run.meter);
    const MeteredBytes refilled_bytes(&run.meter, refilled.byte_count());
    wide::Cells cells = wide::cells_of(refilled, mesh, run.meter);
    run.report.stages.refill = run.clock.lap(refilled.references().size());
    return cells;
}

WideBvh run_pipeline(TriangleMeshView mesh, const BuildOptions& options, BuildReport& report) {
    Run run{{}, {}, wide::kernels_for(choose_isa()), report};
    const Plan plan = make_plan(options.wide, mesh.size());
    const SampleOptions sampling = sampling_of(options, plan, mesh.size());
    wide::Cells cells = plan.by_planes ? make_kd_cells(mesh, sampling, plan.cell_size, run)
                                       : make_object_cells(mesh, sampling, plan.cell_size, run);
    wide::measure_cells(cells, run.kernels);
    wide::GrownTree grown = wide::grow_wide(cells, run.kernels);
    const MeteredBytes part_bytes(&run.meter, byte_count(grown.root));
    WideBvh tree = wide::assemble(std::move(grown), std::move(cells.arena), mesh, run.meter);
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
