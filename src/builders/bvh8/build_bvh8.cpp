#include "coppice/base/error.h"
#include "coppice/base/memory_meter.h"
#include "coppice/builders/build_on_sample.h"
#include "coppice/builders/build_tree.h"
#include "coppice/builders/draw_sample.h"
#include "coppice/builders/empty_leaves.h"
#include "coppice/builders/estimate.h"
#include "coppice/cost/measure.h"

#include "base/out_of_memory.h"
#include "builders/bvh8/grow_bvh8.h"
#include "builders/bvh8/make_prim_refs.h"
#include "builders/bvh8/plan.h"
#include "builders/kernels/bvh8_kernels.h"
#include "builders/require_usable.h"
#include "builders/run_build.h"
#include "builders/stage_clock.h"

#include <fmt/format.h>

#include <string>
#include <utility>

namespace coppice::inline v0 {
namespace {

using bvh8::PrimRef;

// What all stages of a build share.
struct Run {
    StageClock clock;
    MemoryMeter meter;
    const bvh8::Kernels& kernels;
    BuildReport& report;
    Progress* progress;
};

bvh8::ObjectTop build_top(std::span<const PrimRef> prim_refs, const Sample& sample,
                          std::uint32_t cell_size, const bvh8::Kernels& kernels) {
    std::vector<PrimRef> sampled(sample.ids.size());
    for (std::size_t at = 0; at < sampled.size(); ++at) {
        sampled[at] = prim_refs[sample.ids[at]];
        sampled[at].weight = sample.weights.empty() ? static_cast<float>(prim_refs.size()) /
                                                          static_cast<float>(sample.ids.size())
                                                    : sample.weights[at];
    }
    return bvh8::build_object_top(sampled, static_cast<float>(cell_size), kernels);
}

// Cells by centroids; without a sample one cell of everything.
bvh8::Cells make_object_cells(TriangleMeshView mesh, const bvh8::Plan& plan, Run& run) {
    const auto room = static_cast<std::uint32_t>(plan.room * mesh.size());
    bvh8::DoubleBuffer buffers(room, run.meter);
    bvh8::Cells cells{{}, std::move(buffers), {}};
    const std::span<PrimRef> prim_refs = cells.buffers.first().first(mesh.size());
    begin_stage(run.progress, 0.2);
    bvh8::make_prim_refs(mesh, prim_refs);
    const std::uint32_t count = mesh.size();
    run.report.sample_count = sample_count(count, plan.sampling.rate);
    if (run.report.sample_count == count) {
        run.report.stages.sample = run.clock.lap(count);
        cells.ranges.push_back(
            {.begin = 0, .end = count, .buffer = 0, .spare_above = room - count});
        return cells;
    }
    const Sample sample = draw_sample(bvh8::PrimRefSet(prim_refs), plan.sampling);
    run.report.sample_count = static_cast<std::uint32_t>(sample.ids.size());
    run.report.stages.sample = run.clock.lap(sample.ids.size());
    begin_stage(run.progress, 0.01);
    bvh8::ObjectTop top = build_top(prim_refs, sample, plan.cell_size, run.kernels);
    run.report.stages.build = run.clock.lap(top.tree.nodes().size());
    begin_stage(run.progress, 0.07);
    cells.ranges = bvh8::fill_cells(top, prim_refs, cells.buffers.second());
    cells.top = std::move(top.tree);
    run.report.stages.refill = run.clock.lap(count);
    return cells;
}

// Cells by planes: the first stages of a k-d tree.
bvh8::Cells make_kd_cells(TriangleMeshView mesh, const bvh8::Plan& plan, Run& run) {
    begin_stage(run.progress, 0.13);
    require_usable(mesh);
    const BuildOptions options{.sample = plan.sampling,
                               .split = {.rule = "binned",
                                         .max_leaf = plan.cell_size,
                                         .bad_refines = 1,
                                         .sample_weighting = SampleWeighting::expected},
                               .leaf_refinement = LeafRefinement::none,
                               .cost = {.empty_bonus = 0.0}};
    const Sample sample = draw_sample(mesh, plan.sampling);
    run.report.sample_count = static_cast<std::uint32_t>(sample.ids.size());
    run.report.stages.sample = run.clock.lap(sample.ids.size());
    begin_stage(run.progress, 0.5 * plan.sampling.rate);
    KdTree sampled = build_on_sample(mesh, sample, options, &run.meter, run.progress);
    run.report.stages.build = run.clock.lap(sampled.nodes().size());
    begin_stage(run.progress, 0.27);
    const Skeleton skeleton = empty_leaves(std::move(sampled));
    run.report.stages.empty = run.clock.lap(skeleton.nodes().size());
    bvh8::Cells cells = bvh8::make_cells(skeleton, mesh, run.meter);
    run.report.stages.refill = run.clock.lap(cells.ranges.empty() ? 0 : cells.ranges.back().end);
    return cells;
}

Bvh8 run_pipeline(TriangleMeshView mesh, const BuildOptions& options, BuildReport& report,
                  Progress* progress) {
    Run run{{}, {}, bvh8::kernels_for(choose_isa()), report, progress};
    const bvh8::Plan plan = bvh8::make_plan(options, mesh.size());
    report.preset = plan.preset;
    report.options.sample = plan.sampling;
    bvh8::Cells cells =
        plan.by_planes ? make_kd_cells(mesh, plan, run) : make_object_cells(mesh, plan, run);
    begin_stage(progress, plan.by_planes ? 0.46 : 0.6);
    bvh8::measure_cells(cells, run.kernels);
    bvh8::GrownTree grown = bvh8::grow_bvh8(cells, mesh, run.kernels, progress);
    const MeteredBytes part_bytes(&run.meter, byte_count(grown.root));
    begin_stage(progress, 0.06);
    Bvh8 tree =
        bvh8::assemble(std::move(grown), std::move(cells.buffers), mesh, run.kernels, run.meter);
    report.stages.refine = run.clock.lap(tree.blocks().size());
    report.peak_bytes = run.meter.peak_bytes();
    return tree;
}

// The options to build by under a memory limit: those given, or, where the preset is left to us,
// the smallest preset. Tells the report what it estimated and why it chose so.
BuildOptions keep_within_limit(TriangleMeshView mesh, const BuildOptions& options,
                               const BuildControl& control, BuildReport& report) {
    if (control.memory_limit_bytes == 0) return options;
    report.estimate = estimate_bvh8(mesh, options, control.stop);
    if (is_within_limit(*report.estimate, control)) return options;
    const bvh8::Plan plan = bvh8::make_plan(options, mesh.size());
    const std::string excess = excess_text(name_of(plan.preset), *report.estimate, control);
    if (options.bvh8.preset != Bvh8Preset::automatic || plan.preset == Bvh8Preset::fast) {
        throw Error(ErrorCode::limit, excess);
    }
    BuildOptions smaller = options;
    smaller.bvh8.expected_rays = 0.0;  // chooses fast
    report.estimate = estimate_bvh8(mesh, smaller, control.stop);
    if (!is_within_limit(*report.estimate, control)) {
        throw Error(ErrorCode::limit, excess_text("even fast", *report.estimate, control));
    }
    report.preset_reason = excess;
    return smaller;
}

// All full blocks that a tree can have would not hold more.
void require_few_enough(TriangleMeshView mesh) {
    constexpr std::uint32_t most = bvh8_width * (Bvh8Child::max_block_index + 1);
    if (mesh.size() <= most) return;
    throw Error(ErrorCode::limit,
                fmt::format("{} triangles; an 8-wide tree can hold at most {}", mesh.size(), most));
}

Bvh8 build(TriangleMeshView mesh, const BuildOptions& options, BuildReport* report,
           const BuildControl& control) {
    require_few_enough(mesh);
    BuildReport own_report;
    own_report.options = options;
    own_report.primitive_count = mesh.size();
    const BuildOptions within_limit = keep_within_limit(mesh, options, control, own_report);
    Bvh8 tree;
    run_build(within_limit, control, [&](Progress* progress) {
        tree = run_pipeline(mesh, within_limit, own_report, progress);
        if (report == nullptr) return;
        begin_stage(progress, 0.05);
        own_report.tree_bytes = tree.byte_count();
        own_report.peak_bytes = std::max(own_report.peak_bytes, own_report.tree_bytes);
        own_report.statistics = measure(tree, options.cost);
    });
    if (report != nullptr) *report = std::move(own_report);
    return tree;
}

}  // namespace

Bvh8 build_bvh8(TriangleMeshView mesh, const BuildOptions& options, BuildReport* report,
                const BuildControl& control) {
    return with_memory_errors("the build", [&] { return build(mesh, options, report, control); });
}

}  // namespace coppice::inline v0
