#include "coppice/build/build_tree.h"

#include "coppice/base/parallel.h"
#include "coppice/base/timer.h"
#include "coppice/build/build_on_sample.h"
#include "coppice/build/draw_sample.h"
#include "coppice/build/empty_leaves.h"
#include "coppice/build/refill.h"
#include "coppice/build/refine.h"
#include "coppice/cost/measure.h"

#include "build/finite_boxes.h"

#include <utility>

namespace coppice {
namespace {

// Seconds since the last lap.
double lap(Timer& timer) {
    const double seconds = timer.seconds();
    timer.restart();
    return seconds;
}

KdTree run_pipeline(PrimitiveSetView primitives, const BuildOptions& options, BuildReport& report) {
    Timer timer;
    StageSeconds& seconds = report.seconds;

    const Sample sample = draw_sample(primitives, options.sample);
    seconds.sample = lap(timer);
    KdTree sampled = build_on_sample(primitives, sample, options);
    seconds.build = lap(timer);
    Skeleton skeleton = empty_leaves(std::move(sampled));
    seconds.empty = lap(timer);
    KdTree refilled = refill(std::move(skeleton), primitives, options);
    seconds.refill = lap(timer);
    KdTree tree = refine(std::move(refilled), primitives, options);
    seconds.refine = lap(timer);

    report.sample_count = static_cast<std::uint32_t>(sample.ids.size());
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
    run_with_threads(options.threads, [&] {
        require_finite_boxes(primitives);
        tree = run_pipeline(primitives, options, own_report);
    });
    if (report != nullptr) {
        own_report.statistics = measure(tree, options.cost);
        *report = std::move(own_report);
    }
    return tree;
}

}  // namespace coppice
