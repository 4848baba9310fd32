// A bad tree may take a hundred times as long as a good one, which would tell its time no better:
// so runs are repeated for a time, not for a number.

#include "lab/scene_rays.h"

#include "coppice/base/parallel.h"
#include "coppice/base/timer.h"
#include "coppice/build/method.h"

#include "lab/trace_rays.h"
#include "lab/trace_results.h"

#include <algorithm>
#include <type_traits>
#include <utility>

namespace coppice::lab {

namespace {

constexpr std::size_t most_runs = 5;
constexpr double enough_seconds = 0.3;

std::uint64_t count_mismatches(std::span<const Hit> hits, std::span<const Hit> expected) {
    std::uint64_t count = 0;
    for (std::size_t i = 0; i < hits.size(); ++i) {
        count += is_same_distance(hits[i].t, expected[i].t) ? 0 : 1;
    }
    return count;
}

MeanSteps mean_of(std::span<const TraversalCounts> counts) {
    TraversalCounts sum;
    for (const TraversalCounts& of_ray : counts) {
        sum += of_ray;
    }
    const auto ray_count = static_cast<double>(counts.size());
    return {static_cast<double>(sum.nodes) / ray_count, static_cast<double>(sum.leaves) / ray_count,
            static_cast<double>(sum.primitives) / ray_count};
}

/// The median of a few runs' wall-clock seconds.
template <typename Run>
double median_seconds(Run&& run) {
    std::vector<double> runs;
    double total = 0.0;
    while (runs.size() < most_runs && (runs.empty() || total < enough_seconds)) {
        const Timer timer;
        run();
        runs.push_back(timer.seconds());
        total += runs.back();
    }
    std::sort(runs.begin(), runs.end());
    return runs[(runs.size() - 1) / 2];
}

}  // namespace

SceneRays::SceneRays(TriangleMeshView mesh, const RayOptions& options,
                     std::span<const RayKind> kinds, int threads, const BuildControl& control)
    : threads_(threads) {
    const Method& method = find_method(reference_method());
    BuildOptions build = method.options();
    build.threads = threads;
    run_with_threads(threads, [&] {
        const TracedTree tree(mesh, method.tree, build, control);
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
        figures.steps = mean_of(counts);
    } else {
        trace_rays(tracer, set.kind, set.rays, hits);
    }
    figures.mismatches = count_mismatches(hits, set.expected);
    figures.wall_seconds = median_seconds([&] { trace_rays(tracer, set.kind, set.rays, hits); });
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
