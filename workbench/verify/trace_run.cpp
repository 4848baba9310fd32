// Rays are traced once, and a second time if visits are counted. The exact judge decides every ray
// that the reference does not agree on; no tolerance accepts it.

#include "verify/trace_run.h"

#include "coppice/base/error.h"
#include "coppice/base/parallel.h"
#include "coppice/base/timer.h"
#include "coppice/builders/method.h"
#include "coppice/store/tree_file.h"

#include "scenes/load_triangles.h"
#include "scenes/ray_maker.h"
#include "scenes/room_view.h"
#include "scenes/scene_names.h"
#include "scenes/trace_rays.h"
#include "tracers/memory_limit.h"
#include "tracers/traced_tree.h"
#include "verify/trace_check.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <utility>

namespace coppice::lab {

namespace {

CountSummary count(const TracedTree& tree, RayKind kind, std::span<const Ray> rays) {
    std::vector<Hit> hits(rays.size());
    std::vector<TraversalCounts> counts(rays.size());
    trace_counting(tree, kind, rays, hits, counts);
    std::vector<std::uint32_t> numbers(rays.size());
    const auto distribution = [&](std::uint64_t TraversalCounts::*member) {
        std::transform(counts.begin(), counts.end(), numbers.begin(), [&](const auto& of_ray) {
            return static_cast<std::uint32_t>(of_ray.*member);
        });
        return distribution_of(numbers);
    };
    return {distribution(&TraversalCounts::nodes), distribution(&TraversalCounts::leaves),
            distribution(&TraversalCounts::primitives)};
}

/// What all scenes of a run share.
struct Run {
    const TraceOptions& options;
    const TraceObserver& observer;

    void tell(const std::string& step) const {
        if (observer.on_progress) observer.on_progress(step);
    }
};

/// One scene with its tree and rays.
class SceneTrace {
public:
    SceneTrace(const Run& run, TraceScene& scene, TriangleMeshView mesh)
        : run_(run), scene_(scene), mesh_(mesh) {
        const Aabb box = bounds_of(mesh.vertices());
        scene_.camera = choose_ray_camera(mesh, run.options.camera, threads_of(run.options.build));
        scene_.light = render::place_light(scene_.camera, box);
    }

    void run_all() {
        const Timer timer;
        if (run_.options.tree.empty()) {
            tell("building");
            BuildControl control = limit_memory(run_.options.memory_limit_bytes, mesh_);
            control.is_measured = false;
            AnyBuild built = build_tree(mesh_, run_.options.build, control);
            scene_.notes = std::move(built.report.notes);
            tree_.emplace(mesh_, std::move(built.tree));
            scene_.method = run_.options.method;
        } else {
            tell("loading its tree");
            SavedTree saved = load_tree(run_.options.tree, fingerprint_of(mesh_));
            tree_.emplace(mesh_, std::move(saved.tree));
            scene_.method = saved.origin.method;
        }
        scene_.build_seconds = timer.seconds();
        const TraceOptions& options = run_.options;
        maker_.emplace(mesh_, *tree_,
                       RayOptions{scene_.camera, scene_.light, options.size, options.seed});
        if (run_.options.check != TraceCheck::none) {
            check_.emplace(mesh_, run_.options.check, threads_of(run_.options.build));
        }
        for (const RayKind kind : run_.options.rays) {
            scene_.rows.push_back(run_kind(kind));
        }
    }

private:
    TraceRow run_kind(RayKind kind) {
        const std::string name(name_of(kind));
        tell(name + " rays");
        const std::vector<Ray> rays = maker_->make(kind);
        TraceRow row{.kind = kind, .rays = rays.size()};
        if (rays.empty()) return row;
        std::vector<Hit> hits(rays.size());
        const Timer timer;
        trace_rays(*tree_, kind, rays, hits);
        row.seconds = timer.seconds();
        row.hits = static_cast<std::uint64_t>(
            std::count_if(hits.begin(), hits.end(), [](const Hit& hit) { return hit.is_hit(); }));
        if (run_.options.counts) {
            tell(name + " rays, counting");
            row.counts = count(*tree_, kind, rays);
        }
        if (check_) {
            tell(name + " rays, checking");
            row.comparison = check_->compare(*tree_, kind, rays, hits);
        }
        return row;
    }

    void tell(const std::string& step) const { run_.tell(scene_.scene + ": " + step); }

    const Run& run_;
    TraceScene& scene_;
    TriangleMeshView mesh_;
    std::optional<TracedTree> tree_;
    std::optional<HitCheck> check_;
    std::optional<RayMaker> maker_;
};

void check(const TraceOptions& options) {
    static_cast<void>(find_method(options.method));
    if (options.size < 1 || options.size > TraceOptions::max_size) {
        throw Error(ErrorCode::invalid_argument, fmt::format("size {} is outside [1, {}]",
                                                             options.size, TraceOptions::max_size));
    }
    if (!options.tree.empty() && options.scenes.size() > 1) {
        throw Error(ErrorCode::invalid_argument,
                    "a saved tree belongs to one scene; give only that scene");
    }
    HitCheck::require(options.check);
}

}  // namespace

std::string_view name_of(TraceCheck check) noexcept {
    return check == TraceCheck::none ? "none" : check == TraceCheck::embree ? "embree" : "brute";
}

std::vector<TraceScene> run_trace(const TraceOptions& options, const TraceObserver& observer) {
    check(options);
    const Run run{options, observer};
    std::vector<TraceScene> scenes;
    const std::vector<std::string> names = scene_names(options.scenes);
    for (std::size_t i = 0; i < names.size(); ++i) {
        TraceScene& scene = scenes.emplace_back();
        scene.scene = names[i];
        scene.file = options.scenes[i];
        run.tell(scene.scene + ": loading");
        const TriangleMesh mesh = load_triangles(scene.file);
        scene.triangles = mesh.triangles.size();
        run_with_threads(threads_of(options.build),
                         [&] { SceneTrace(run, scene, mesh.view()).run_all(); });
        if (observer.on_scene) observer.on_scene(scene);
    }
    return scenes;
}

}  // namespace coppice::lab
