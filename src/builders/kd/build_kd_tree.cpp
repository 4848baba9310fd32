#include "coppice/base/error.h"
#include "coppice/builders/build_on_sample.h"
#include "coppice/builders/build_tree.h"
#include "coppice/builders/draw_sample.h"
#include "coppice/builders/empty_leaves.h"
#include "coppice/builders/estimate.h"
#include "coppice/builders/refill.h"
#include "coppice/builders/refine.h"

#include "base/out_of_memory.h"
#include "builders/require_usable.h"
#include "builders/run_build.h"

#include <utility>

namespace coppice::inline v0 {
namespace {

// True if the later stages cannot change the tree: it was built from all primitives until no split
// pays. Refilling would restore its leaves, and growing would find no split.
bool is_complete(const Sample& sample, PrimitiveSetView primitives, const KdOptions& options) {
    return sample.ids.size() == primitives.size() && options.split.termination == Termination::sah;
}

// The stages' shares of the build time, by the options alone, measured on a scanned mesh; for
// progress reports.
struct Shares {
    double sample = 0.03;
    double build = 0.0;
    double empty = 0.0;  // takes negligible time
    double refill = 0.0;
    double refine = 0.0;
    double measure = 0.05;

    explicit Shares(const KdOptions& options) {
        constexpr double refill_share = 0.1;
        constexpr double refine_share = 1.0;
        constexpr double refine_share_of_whole = 0.3;
        build = options.sample.rate;
        const bool is_whole = options.sample.rate == 1.0;
        if (!is_whole || options.split.termination != Termination::sah) refill = refill_share;
        if (options.leaf_refinement == LeafRefinement::kd && refill > 0.0) {
            refine = is_whole ? refine_share_of_whole : refine_share;
        }
        const double sum = sample + build + refill + refine + measure;
        for (double* share : {&sample, &build, &refill, &refine, &measure}) {
            *share /= sum;
        }
    }
};

std::size_t sampled_count(const Sample& sample) {
    return sample.ids.size();
}

std::size_t node_count(const KdTree& tree) {
    return tree.nodes().size();
}

std::size_t kept_count(const Skeleton& skeleton) {
    return skeleton.nodes().size();
}

std::size_t reference_count(const KdTree& tree) {
    return tree.references().size();
}

// The stages of the pipeline, in order, and the memory of what each passes to the next.
class KdPipeline {
public:
    KdPipeline(PrimitiveSetView primitives, const KdOptions& options, BuildRun& run)
        : primitives_(primitives),
          options_(options),
          run_(run),
          context_(run.context()),
          stages_(run.report().stages),
          shares_(options) {}

    [[nodiscard]] KdTree run() && {
        const Sample sample = draw();
        KdTree sampled = build(sample);
        if (is_complete(sample, primitives_, options_)) return sampled;
        Skeleton skeleton = empty(std::move(sampled));
        KdTree refilled = fill(std::move(skeleton));
        return grow(std::move(refilled));
    }

private:
    Sample draw() {
        const auto work = [&] {
            require_usable(primitives_);  // counted in the time of the first stage
            return draw_sample(primitives_, options_.sample);
        };
        Sample sample = run_.stage(stages_.sample, shares_.sample, work, sampled_count);
        run_.report().sample_count = static_cast<std::uint32_t>(sample.ids.size());
        if (sample.ids.size() == primitives_.size()) run_.report().sample.rate = 1.0;
        sample_bytes_ = {context_.memory, sample.ids};
        return sample;
    }

    KdTree build(const Sample& sample) {
        const auto work = [&] { return build_on_sample(primitives_, sample, options_, context_); };
        return held(run_.stage(stages_.build, shares_.build, work, node_count));
    }

    Skeleton empty(KdTree&& sampled) {
        const auto work = [&] { return empty_leaves(std::move(sampled)); };
        Skeleton skeleton = run_.stage(stages_.empty, shares_.empty, work, kept_count);
        tree_bytes_ = {context_.memory, skeleton.nodes().size_bytes()};
        return skeleton;
    }

    KdTree fill(Skeleton&& skeleton) {
        const auto work = [&] {
            return refill(std::move(skeleton), primitives_, options_, context_);
        };
        return held(run_.stage(stages_.refill, shares_.refill, work, reference_count));
    }

    KdTree grow(KdTree&& refilled) {
        const auto work = [&] {
            return refine(std::move(refilled), primitives_, options_, context_);
        };
        return held(run_.stage(stages_.refine, shares_.refine, work, reference_count));
    }

    KdTree held(KdTree tree) {
        tree_bytes_ = {context_.memory, tree.byte_count()};
        return tree;
    }

    PrimitiveSetView primitives_;
    const KdOptions& options_;
    BuildRun& run_;
    BuildContext context_;
    StageReports& stages_;
    Shares shares_;
    MeteredBytes sample_bytes_;
    MeteredBytes tree_bytes_;
};

void keep_within_limit(PrimitiveSetView primitives, const KdOptions& options,
                       const BuildControl& control, BuildReport& report) {
    if (control.memory_limit_bytes == 0) return;
    report.estimate = estimate_kd_tree(primitives, options, control.stop);
    if (is_within_limit(*report.estimate, control)) return;
    throw Error(ErrorCode::limit, excess_text("the build", *report.estimate, control));
}

KdBuild build(PrimitiveSetView primitives, const KdOptions& options, const BuildControl& control) {
    require_valid(options);
    KdBuild build{{}, begin_report(options, primitives.size())};
    keep_within_limit(primitives, options, control, build.report);
    build.tree =
        run_build(options, control, build.report, Shares(options).measure,
                  [&](BuildRun& run) { return KdPipeline(primitives, options, run).run(); });
    return build;
}

}  // namespace

KdBuild build_kd_tree(PrimitiveSetView primitives, const KdOptions& options,
                      const BuildControl& control) {
    return with_memory_errors("the build", [&] { return build(primitives, options, control); });
}

}  // namespace coppice::inline v0
