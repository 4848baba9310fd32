#include "coppice/build/build_tree.h"

#include "coppice/base/memory_meter.h"
#include "coppice/base/parallel.h"
#include "coppice/build/build_on_sample.h"
#include "coppice/build/draw_sample.h"
#include "coppice/build/empty_leaves.h"
#include "coppice/build/refill.h"
#include "coppice/build/refine.h"
#include "coppice/cost/measure.h"

#include "build/finite_boxes.h"
#include "build/stage_clock.h"

#include <utility>

namespace coppice {
namespace {

// A tree of all primitives that was built until no split pays has nothing to gain from the later
// stages: refilling gives back its leaves, and growing finds no split.
bool is_complete(const Sample& sample, PrimitiveSetView primitives, const BuildOptions& options) {
    return sample.ids.size() == primitives.size() && options.split.stop == Stop::sah;
}

KdTree run_pipeline(PrimitiveSetView primitives, const BuildOptions& options, BuildReport& report) {
    StageClock clock;
    StageReports& stages = report.stages;
    MemoryMeter meter;

    require_finite_boxes(primitives);  // counted as the sample's time, so that nothing is left out
    const Sample sample = draw_sample(primitives, options.sample);
    const MeteredBytes sample_bytes(&meter, sample.ids);
    stages.sample = clock.lap(sample.ids.size());
    KdTree sampled = build_on_sample(primitives, sample, options, &meter);
    MeteredBytes tree_bytes(&meter, sampled.byte_count());
    stages.build = clock.lap(sampled.nodes().size());
    report.sample_count = static_cast<std::uint32_t>(sample.ids.size());
    report.peak_bytes = meter.peak_bytes();
    if (is_complete(sample, primitives, options)) return sampled;
    Skeleton skeleton = empty_leaves(std::move(sampled));
    tree_bytes = {&meter, skeleton.nodes().size_bytes()};
    stages.empty = clock.lap(skeleton.nodes().size());
    KdTree refilled = refill(std::move(skeleton), primitives, options, &meter);
    tree_bytes = {&meter, refilled.byte_count()};
    stages.refill = clock.lap(refilled.references().size());
    KdTree tree = refine(std::move(refilled), primitives, options, &meter);
    tree_bytes = {&meter, tree.byte_count()};
    stages.refine = clock.lap(tree.references().size());
    report.peak_bytes = meter.peak_bytes();
    return tree;
}

}  // namespace

KdTree build_kd_tree(PrimitiveSetView primitives, const BuildOptions& options,
                     BuildReport* report) {
    check(options);
    BuildReport own_report;
    own_report.options = options;
    own_report.primitive_count = primitives.size();
    KdTree tree;
    run_with_threads(options.threads,
                     [&] { tree = run_pipeline(primitives, options, own_report); });
    if (report != nullptr) {
        own_report.tree_bytes = tree.byte_count();
        own_report.statistics = measure(tree, options.cost);
        *report = std::move(own_report);
    }
    return tree;
}

}  // namespace coppice
