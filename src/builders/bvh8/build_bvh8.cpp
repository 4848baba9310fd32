#include "coppice/base/error.h"
#include "coppice/builders/build_on_sample.h"
#include "coppice/builders/build_tree.h"
#include "coppice/builders/draw_sample.h"
#include "coppice/builders/empty_leaves.h"
#include "coppice/builders/estimate.h"

#include "base/out_of_memory.h"
#include "builders/bvh8/grow_bvh8.h"
#include "builders/bvh8/make_prim_refs.h"
#include "builders/bvh8/plan.h"
#include "builders/kernels/bvh8_kernels.h"
#include "builders/require_usable.h"
#include "builders/run_build.h"

#include <fmt/format.h>

#include <string>
#include <utility>

namespace coppice::inline v0 {
namespace {

// The stages' shares of the build time, measured on a scanned mesh; for progress reports.
struct Shares {
    double sample;
    double build;
    double refill;
    double grow;
    double assemble = 0.06;
    double measure = 0.05;
};

Shares shares_of(const bvh8::Plan& plan) {
    constexpr Shares by_centroids{.sample = 0.2, .build = 0.01, .refill = 0.07, .grow = 0.6};
    if (!plan.by_planes) return by_centroids;
    return {.sample = 0.13, .build = 0.5 * plan.sampling.rate, .refill = 0.27, .grow = 0.46};
}

std::size_t sampled_count(const Sample& sample) {
    return sample.ids.size();
}

bvh8::ObjectTop build_top(std::span<const bvh8::PrimRef> prim_refs, const Sample& sample,
                          std::uint32_t cell_size, const bvh8::Kernels& kernels) {
    std::vector<bvh8::PrimRef> sampled(sample.ids.size());
    for (std::size_t at = 0; at < sampled.size(); ++at) {
        sampled[at] = prim_refs[sample.ids[at]];
        sampled[at].weight = sample.weights.empty() ? static_cast<float>(prim_refs.size()) /
                                                          static_cast<float>(sample.ids.size())
                                                    : sample.weights[at];
    }
    return bvh8::build_object_top(sampled, static_cast<float>(cell_size), kernels);
}

// The stages of the pipeline, in order.
class Bvh8Pipeline {
public:
    Bvh8Pipeline(TriangleMeshView mesh, const bvh8::Plan& plan, BuildRun& run)
        : mesh_(mesh),
          plan_(plan),
          run_(run),
          context_(run.context()),
          report_(run.report()),
          stages_(run.report().stages),
          kernels_(bvh8::kernels_for(choose_isa())),
          shares_(shares_of(plan)) {}

    [[nodiscard]] Bvh8 run() && {
        bvh8::Cells cells = plan_.by_planes ? make_kd_cells() : make_object_cells();
        return grow(std::move(cells));
    }

private:
    // Makes cells by centroids; without a sample, a single cell of all triangles.
    bvh8::Cells make_object_cells() {
        const std::uint32_t count = mesh_.size();
        const auto room = static_cast<std::uint32_t>(plan_.room * count);
        bvh8::DoubleBuffer buffers(room, *context_.memory);
        bvh8::Cells cells{{}, std::move(buffers), {}};
        const std::span<bvh8::PrimRef> prim_refs = cells.buffers.first().first(count);
        report_.sample_count = sample_count(count, plan_.sampling.rate);
        const bool is_whole = report_.sample_count == count;
        const auto draw = [&] {
            bvh8::make_prim_refs(mesh_, prim_refs);
            return is_whole ? Sample{} : draw_sample(bvh8::PrimRefSet(prim_refs), plan_.sampling);
        };
        const Sample sample =
            run_.stage(stages_.sample, shares_.sample, draw,
                       [&](const Sample& drawn) { return is_whole ? count : drawn.ids.size(); });
        if (is_whole) {
            cells.ranges.push_back(
                {.begin = 0, .end = count, .buffer = 0, .spare_above = room - count});
            return cells;
        }
        report_.sample_count = static_cast<std::uint32_t>(sample.ids.size());
        const auto build = [&] { return build_top(prim_refs, sample, plan_.cell_size, kernels_); };
        bvh8::ObjectTop top =
            run_.stage(stages_.build, shares_.build, build,
                       [](const bvh8::ObjectTop& built) { return built.tree.nodes().size(); });
        const auto fill = [&] { return bvh8::fill_cells(top, prim_refs, cells.buffers.second()); };
        cells.ranges = run_.stage(stages_.refill, shares_.refill, fill,
                                  [&](const auto& /*ranges*/) { return count; });
        cells.top = std::move(top.tree);
        return cells;
    }

    // Makes cells by planes, with the first stages of a k-d tree.
    bvh8::Cells make_kd_cells() {
        const KdOptions options{.sample = plan_.sampling,
                                .split = {.rule = "binned",
                                          .max_leaf = plan_.cell_size,
                                          .bad_refines = 1,
                                          .sample_weighting = SampleWeighting::expected},
                                .leaf_refinement = LeafRefinement::none,
                                .cost = {.empty_bonus = 0.0}};
        const auto draw = [&] {
            require_usable(mesh_);
            return draw_sample(mesh_, plan_.sampling);
        };
        const Sample sample = run_.stage(stages_.sample, shares_.sample, draw, sampled_count);
        report_.sample_count = static_cast<std::uint32_t>(sample.ids.size());
        const auto build = [&] { return build_on_sample(mesh_, sample, options, context_); };
        KdTree sampled = run_.stage(stages_.build, shares_.build, build,
                                    [](const KdTree& tree) { return tree.nodes().size(); });
        const auto empty = [&] { return empty_leaves(std::move(sampled)); };
        const Skeleton skeleton =
            run_.stage(stages_.empty, 0.0, empty,
                       [](const Skeleton& emptied) { return emptied.nodes().size(); });
        const auto fill = [&] { return bvh8::make_cells(skeleton, mesh_, *context_.memory); };
        return run_.stage(stages_.refill, shares_.refill, fill, [](const bvh8::Cells& cells) {
            return cells.ranges.empty() ? 0U : cells.ranges.back().end;
        });
    }

    // Builds the tree below and above the cells.
    Bvh8 grow(bvh8::Cells&& cells) {
        const auto work = [&] {
            bvh8::measure_cells(cells, kernels_);
            bvh8::GrownTree grown = bvh8::grow_bvh8(cells, mesh_, kernels_, context_.progress);
            const MeteredBytes part_bytes(context_.memory, byte_count(grown.root));
            run_.begin(shares_.assemble);
            return bvh8::assemble(std::move(grown), std::move(cells.buffers), mesh_, kernels_,
                                  *context_.memory);
        };
        return run_.stage(stages_.refine, shares_.grow, work,
                          [](const Bvh8& tree) { return tree.blocks().size(); });
    }

    TriangleMeshView mesh_;
    const bvh8::Plan& plan_;
    BuildRun& run_;
    BuildContext context_;
    BuildReport& report_;
    StageReports& stages_;
    const bvh8::Kernels& kernels_;
    Shares shares_;
};

// The options for a build under a memory limit: the given ones, or, with the preset `automatic`,
// the smallest preset if the chosen one exceeds the limit. Stores the estimate and the reason in
// the report. Throws Error(limit) if no preset fits.
Bvh8Options keep_within_limit(TriangleMeshView mesh, const Bvh8Options& options,
                              const BuildControl& control, BuildReport& report) {
    if (control.memory_limit_bytes == 0) return options;
    report.estimate = estimate_bvh8(mesh, options, control.stop);
    if (is_within_limit(*report.estimate, control)) return options;
    const bvh8::Plan plan = bvh8::make_plan(options, mesh.size());
    const std::string excess = excess_text(name_of(plan.preset), *report.estimate, control);
    if (options.preset != Bvh8Preset::automatic || plan.preset == Bvh8Preset::fast) {
        throw Error(ErrorCode::limit, excess);
    }
    Bvh8Options smaller = options;
    smaller.expected_rays = 0.0;  // makes `automatic` choose fast
    report.estimate = estimate_bvh8(mesh, smaller, control.stop);
    if (!is_within_limit(*report.estimate, control)) {
        throw Error(ErrorCode::limit, excess_text("even fast", *report.estimate, control));
    }
    report.preset_reason = excess;
    return smaller;
}

// Throws Error(limit) for more triangles than the greatest number of full blocks can hold.
void require_few_enough(TriangleMeshView mesh) {
    constexpr std::uint32_t most = bvh8_width * (Bvh8Child::max_block_index + 1);
    if (mesh.size() <= most) return;
    throw Error(ErrorCode::limit,
                fmt::format("the mesh has {} triangles; an 8-wide tree can hold at most {}",
                            mesh.size(), most));
}

Bvh8Build build(TriangleMeshView mesh, const Bvh8Options& options, const BuildControl& control) {
    require_few_enough(mesh);
    require_valid(options);
    Bvh8Build build{{}, begin_report(options, mesh.size())};
    const Bvh8Options within_limit = keep_within_limit(mesh, options, control, build.report);
    const bvh8::Plan plan = bvh8::make_plan(within_limit, mesh.size());
    build.report.preset = plan.preset;
    build.report.sample = plan.sampling;
    build.tree = run_build(options, control, build.report, shares_of(plan).measure,
                           [&](BuildRun& run) { return Bvh8Pipeline(mesh, plan, run).run(); });
    return build;
}

}  // namespace

Bvh8Build build_bvh8(TriangleMeshView mesh, const Bvh8Options& options,
                     const BuildControl& control) {
    return with_memory_errors("the build", [&] { return build(mesh, options, control); });
}

}  // namespace coppice::inline v0
