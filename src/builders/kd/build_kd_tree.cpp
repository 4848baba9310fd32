#include "coppice/base/error.h"
#include "coppice/base/memory_meter.h"
#include "coppice/builders/build_on_sample.h"
#include "coppice/builders/build_tree.h"
#include "coppice/builders/draw_sample.h"
#include "coppice/builders/empty_leaves.h"
#include "coppice/builders/estimate.h"
#include "coppice/builders/refill.h"
#include "coppice/builders/refine.h"
#include "coppice/cost/measure.h"

#include "base/out_of_memory.h"
#include "builders/require_usable.h"
#include "builders/run_build.h"
#include "builders/stage_clock.h"

#include <utility>

namespace coppice::inline v0 {
namespace {

// A tree of all primitives that was built until no split pays has nothing to gain from the later
// stages: refilling gives back its leaves, and growing finds no split.
bool is_complete(const Sample& sample, PrimitiveSetView primitives, const BuildOptions& options) {
    return sample.ids.size() == primitives.size() && options.split.termination == Termination::sah;
}

// The stages' shares of the time, for Progress: for a scanned mesh, by the options alone.
struct Shares {
    double sample = 0.03;
    double build = 0.0;
    double refill = 0.0;
    double refine = 0.0;
    double measure = 0.05;

    explicit Shares(const BuildOptions& options) {
        build = options.sample.rate;
        const bool is_whole = options.sample.rate == 1.0;
        if (!is_whole || options.split.termination != Termination::sah) refill = 0.1;
        if (options.leaf_refinement == LeafRefinement::kd && refill > 0.0)
            refine = is_whole ? 0.3 : 1.0;
        const double sum = sample + build + refill + refine + measure;
        for (double* share : {&sample, &build, &refill, &refine, &measure}) {
            *share /= sum;
        }
    }
};

KdTree run_pipeline(PrimitiveSetView primitives, const BuildOptions& options, BuildReport& report,
                    Progress* progress) {
    StageClock clock;
    StageReports& stages = report.stages;
    MemoryMeter meter;
    const Shares shares(options);

    begin_stage(progress, shares.sample);
    require_usable(primitives);  // counted as the sample's time, so that nothing is left out
    const Sample sample = draw_sample(primitives, options.sample);
    const MeteredBytes sample_bytes(&meter, sample.ids);
    stages.sample = clock.lap(sample.ids.size());
    begin_stage(progress, shares.build);
    KdTree sampled = build_on_sample(primitives, sample, options, &meter, progress);
    MeteredBytes tree_bytes(&meter, sampled.byte_count());
    stages.build = clock.lap(sampled.nodes().size());
    report.sample_count = static_cast<std::uint32_t>(sample.ids.size());
    report.peak_bytes = meter.peak_bytes();
    if (is_complete(sample, primitives, options)) return sampled;
    begin_stage(progress, shares.refill);
    Skeleton skeleton = empty_leaves(std::move(sampled));
    tree_bytes = {&meter, skeleton.nodes().size_bytes()};
    stages.empty = clock.lap(skeleton.nodes().size());
    KdTree refilled = refill(std::move(skeleton), primitives, options, &meter, progress);
    tree_bytes = {&meter, refilled.byte_count()};
    stages.refill = clock.lap(refilled.references().size());
    begin_stage(progress, shares.refine);
    KdTree tree = refine(std::move(refilled), primitives, options, &meter, progress);
    tree_bytes = {&meter, tree.byte_count()};
    stages.refine = clock.lap(tree.references().size());
    report.peak_bytes = meter.peak_bytes();
    return tree;
}

KdTree build(PrimitiveSetView primitives, const BuildOptions& options, BuildReport* report,
             const BuildControl& control) {
    BuildReport own_report;
    own_report.options = options;
    own_report.primitive_count = primitives.size();
    if (control.memory_limit_bytes != 0) {
        own_report.estimate = estimate_kd_tree(primitives, options, control.stop);
        if (!is_within_limit(*own_report.estimate, control)) {
            throw Error(ErrorCode::limit, excess_text("the build", *own_report.estimate, control));
        }
    }
    KdTree tree;
    run_build(options, control, [&](Progress* progress) {
        tree = run_pipeline(primitives, options, own_report, progress);
        if (report == nullptr) return;
        begin_stage(progress, Shares(options).measure);
        own_report.tree_bytes = tree.byte_count();
        own_report.peak_bytes = std::max(own_report.peak_bytes, own_report.tree_bytes);
        own_report.statistics = measure(tree, options.cost);
    });
    if (report != nullptr) *report = std::move(own_report);
    return tree;
}

}  // namespace

KdTree build_kd_tree(PrimitiveSetView primitives, const BuildOptions& options, BuildReport* report,
                     const BuildControl& control) {
    return with_memory_errors("the build",
                              [&] { return build(primitives, options, report, control); });
}

}  // namespace coppice::inline v0
