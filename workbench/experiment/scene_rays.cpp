// Each tree takes turns with the same reference tree. What slows the machine down for a while slows
// both, and the reference's runs tell by how much. All kinds of rays are taken together for that,
// because single runs scatter. Turns of all trees with each other would need all of them in memory;
// this needs one more. Runs are repeated for a time and not for a number: more runs of a slow tree
// would not make its time more certain.

#include "experiment/scene_rays.h"

#include "coppice/base/parallel.h"
#include "coppice/base/timer.h"
#include "coppice/builders/method.h"

#include "scenes/trace_rays.h"
#include "statistics/median.h"
#include "tracers/hit_agreement.h"

#include <algorithm>
#include <type_traits>
#include <utility>

namespace coppice::lab {

namespace {

constexpr std::size_t most_turns = 7;
constexpr double enough_seconds = 0.3;

MeanSteps mean_steps(std::span<const TraversalCounts> counts) {
    TraversalCounts sum;
    for (const TraversalCounts& of_ray : counts) {
        sum += of_ray;
    }
    const auto ray_count = static_cast<double>(counts.size());
    return {static_cast<double>(sum.nodes) / ray_count, static_cast<double>(sum.leaves) / ray_count,
            static_cast<double>(sum.primitives) / ray_count};
}

/// Something to be timed, as many times in a row as a clock and a scheduler can tell.
template <typename Run>
class TimedRun {
public:
    explicit TimedRun(Run run) : run_(std::move(run)) {
        const double seconds = time();
        if (seconds < least_seconds) {
            repeats_ = std::clamp(static_cast<int>(least_seconds / seconds), 1, most_repeats);
        }
    }

    /// Seconds of one.
    [[nodiscard]] double time() {
        const Timer timer;
        for (int i = 0; i < repeats_; ++i) {
            run_();
        }
        return timer.seconds() / repeats_;
    }

    [[nodiscard]] int repeats() const { return repeats_; }

private:
    static constexpr double least_seconds = 0.0005;
    static constexpr int most_repeats = 1000;

    Run run_;
    int repeats_ = 1;
};

/// Runs the two in turns, and notes the medians of their times.
template <typename Run, typename Reference>
void take_turns(TimedRun<Run> run, TimedRun<Reference> reference, RayFigures& figures) {
    std::vector<double> seconds;
    std::vector<double> references;
    double total = 0.0;
    while (seconds.size() < most_turns && (seconds.empty() || total < enough_seconds)) {
        references.push_back(reference.time());
        seconds.push_back(run.time());
        total += seconds.back() * run.repeats();
    }
    figures.wall_seconds = median_of(std::move(seconds));
    figures.reference_seconds = median_of(std::move(references));
}

}  // namespace

SceneRays::SceneRays(TriangleMeshView mesh, const RayOptions& options,
                     std::span<const RayKind> kinds, int threads, const BuildControl& control)
    : threads_(threads) {
    const Method& method = find_method(reference_method);
    BuildOptions build = method.options();
    set_threads(build, threads);
    run_with_threads(threads, [&] {
        const TracedTree& tree = reference_.emplace(mesh, build, control);
        RayMaker maker(mesh, tree, options);
        for (const RayKind kind : kinds) {
            RaySet set{kind, maker.make(kind), {}};
            if (set.rays.empty()) continue;
            set.expected.resize(set.rays.size());
            trace_rays(tree, kind, set.rays, set.expected);
            sets_.push_back(std::move(set));
        }
    });
}

template <typename Tracer>
RayFigures SceneRays::measure_set(const Tracer& tracer, const RaySet& set) const {
    RayFigures figures{.kind = set.kind, .rays = set.rays.size()};
    std::vector<Hit> hits(set.rays.size());
    if constexpr (std::is_same_v<Tracer, TracedTree>) {
        std::vector<TraversalCounts> counts(set.rays.size());
        trace_counting(tracer, set.kind, set.rays, hits, counts);
        figures.steps = mean_steps(counts);
    } else {
        trace_rays(tracer, set.kind, set.rays, hits);
    }
    figures.mismatches = count_mismatches(hits, set.expected);
    take_turns(TimedRun([&] { trace_rays(tracer, set.kind, set.rays, hits); }),
               TimedRun([&] { trace_rays(*reference_, set.kind, set.rays, hits); }), figures);
    return figures;
}

std::vector<RayFigures> SceneRays::measure(const TracedTree& tree) const {
    std::vector<RayFigures> all;
    run_with_threads(threads_, [&] {
        for (const RaySet& set : sets_) {
            all.push_back(measure_set(tree, set));
        }
    });
    return all;
}

std::vector<RayFigures> SceneRays::measure(const Contestant& contestant) const {
    std::vector<RayFigures> all;
    run_with_threads(threads_, [&] {
        for (const RaySet& set : sets_) {
            all.push_back(measure_set(contestant, set));
        }
    });
    return all;
}

}  // namespace coppice::lab
