// Rays are traced once, and for counts a second time. What a reference does not agree on is never
// waved through by a tolerance: the judge says for each such ray what is true.

#include "lab/trace_run.h"

#include "coppice/base/error.h"
#include "coppice/base/parallel.h"
#include "coppice/base/timer.h"
#include "coppice/build/method.h"
#include "coppice/io/load_mesh.h"
#include "coppice/store/tree_file.h"

#include "lab/hard_rays.h"
#include "lab/memory_limit.h"
#include "lab/named.h"
#include "lab/scene_names.h"
#include "lab/trace_check.h"
#include "lab/traced_tree.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <utility>

namespace coppice::lab {

namespace {

constexpr std::size_t chunk_size = 4096;

/// Closest hits; for shadow rays t is 0 where anything is hit.
std::vector<Hit> trace(const TracedTree& tree, RayKind kind, std::span<const Ray> rays,
                       std::vector<Hit> hits) {
    parallel_for_chunks(rays.size(), chunk_size, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
            if (kind == RayKind::shadow) {
                hits[i].t = tree.occluded(rays[i]) ? 0.0F : Hit{}.t;
            } else {
                hits[i] = tree.intersect(rays[i]).value_or(Hit{});
            }
        }
    });
    return hits;
}

CountSummary count(const TracedTree& tree, RayKind kind, std::span<const Ray> rays) {
    std::vector<std::uint32_t> nodes(rays.size());
    std::vector<std::uint32_t> leaves(rays.size());
    std::vector<std::uint32_t> primitives(rays.size());
    parallel_for_chunks(rays.size(), chunk_size, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
            TraversalCounts counts;
            if (kind == RayKind::shadow) {
                static_cast<void>(tree.occluded(rays[i], counts));
            } else {
                static_cast<void>(tree.intersect(rays[i], counts));
            }
            nodes[i] = static_cast<std::uint32_t>(counts.nodes);
            leaves[i] = static_cast<std::uint32_t>(counts.leaves);
            primitives[i] = static_cast<std::uint32_t>(counts.primitives);
        }
    });
    return {distribution_of(nodes), distribution_of(leaves), distribution_of(primitives)};
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
        scene_.camera = render::frame_box(box, run.options.camera, 1.0);
        scene_.light = render::place_light(scene_.camera, box);
    }

    void run_all() {
        const Timer timer;
        if (run_.options.tree.empty()) {
            tell("building");
            tree_.emplace(mesh_, find_method(run_.options.method).tree, run_.options.build,
                          limit_memory(run_.options.memory_limit_bytes, mesh_));
            scene_.method = run_.options.method;
        } else {
            tell("loading its tree");
            SavedTree saved = load_tree(run_.options.tree, fingerprint_of(mesh_));
            tree_.emplace(mesh_, std::move(saved.tree));
            scene_.method = saved.origin.method;
        }
        scene_.build_seconds = timer.seconds();
        if (run_.options.check != TraceCheck::none) {
            check_.emplace(mesh_, run_.options.check, run_.options.build.threads);
        }
        for (const RayKind kind : run_.options.rays) {
            scene_.rows.push_back(run_kind(kind));
        }
    }

private:
    TraceRow run_kind(RayKind kind) {
        const std::string name(ray_kind_registry()[static_cast<std::size_t>(kind)].name);
        tell(name + " rays");
        const std::vector<Ray> rays = make_rays(kind);
        TraceRow row{.kind = kind, .rays = rays.size()};
        if (rays.empty()) return row;
        std::vector<Hit> hits(rays.size());
        const Timer timer;
        hits = trace(*tree_, kind, rays, std::move(hits));
        row.seconds = timer.seconds();
        row.hits = static_cast<std::uint64_t>(std::count_if(
            hits.begin(), hits.end(), [](const Hit& hit) { return std::isfinite(hit.t); }));
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

    [[nodiscard]] std::vector<Ray> make_rays(RayKind kind) {
        const auto size = static_cast<std::size_t>(run_.options.size);
        const std::size_t count = size * size;
        const std::uint64_t seed = run_.options.seed;
        switch (kind) {
            case RayKind::primary:
                return primary_rays(scene_.camera, run_.options.size);
            case RayKind::random:
                return random_rays(mesh_, count, seed);
            case RayKind::axis:
                return axis_rays(mesh_, count, seed);
            case RayKind::grazing:
                return grazing_rays(mesh_, count, seed);
            case RayKind::shadow:
            case RayKind::diffuse:
                break;
        }
        see_surfaces();
        std::vector<Ray> rays = kind == RayKind::shadow
                                    ? shadow_rays(mesh_, seen_rays_, seen_hits_, scene_.light)
                                    : diffuse_rays(mesh_, seen_rays_, seen_hits_, seed);
        rays.resize(std::min(rays.size(), count));
        return rays;
    }

    /// Primary rays for secondary ones to start from: so many that enough of them hit.
    void see_surfaces() {
        if (!seen_rays_.empty()) return;
        const int size = run_.options.size;
        const std::size_t hit_count = look(size);
        const double count = static_cast<double>(size) * size;
        if (hit_count == 0 || hit_count == seen_rays_.size()) return;
        const double more = std::sqrt(1.05 * count / static_cast<double>(hit_count));
        look(static_cast<int>(std::min(4.0, more) * size) + 1);
    }

    std::size_t look(int size) {
        seen_rays_ = primary_rays(scene_.camera, size);
        seen_hits_ =
            trace(*tree_, RayKind::primary, seen_rays_, std::vector<Hit>(seen_rays_.size()));
        return static_cast<std::size_t>(
            std::count_if(seen_hits_.begin(), seen_hits_.end(),
                          [](const Hit& hit) { return std::isfinite(hit.t); }));
    }

    void tell(const std::string& step) const { run_.tell(scene_.scene + ": " + step); }

    const Run& run_;
    TraceScene& scene_;
    TriangleMeshView mesh_;
    std::optional<TracedTree> tree_;
    std::optional<HitCheck> check_;
    std::vector<Ray> seen_rays_;
    std::vector<Hit> seen_hits_;
};

TriangleMesh load_scene(const Run& run, const TraceScene& scene) {
    run.tell(scene.scene + ": loading");
    TriangleMesh mesh = load_mesh(scene.file);
    if (!mesh.triangles.empty()) return mesh;
    throw file_error(ErrorCode::unsupported, scene.file.string(),
                     "no triangles: there is nothing to trace");
}

void check(const TraceOptions& options) {
    static_cast<void>(find_method(options.method));
    if (options.size < 1 || options.size > TraceOptions::max_size) {
        throw Error(ErrorCode::invalid_argument, fmt::format("size {} is outside [1, {}]",
                                                             options.size, TraceOptions::max_size));
    }
    if (!options.tree.empty() && options.scenes.size() > 1) {
        throw Error(ErrorCode::invalid_argument, "a saved tree is for one scene");
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
        const TriangleMesh mesh = load_scene(run, scene);
        scene.triangles = mesh.triangles.size();
        run_with_threads(options.build.threads,
                         [&] { SceneTrace(run, scene, mesh.view()).run_all(); });
        if (observer.on_scene) observer.on_scene(scene);
    }
    return scenes;
}

}  // namespace coppice::lab
