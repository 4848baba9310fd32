#include "exhibits/exhibits.h"

#include "coppice/base/error.h"
#include "coppice/base/parallel.h"
#include "coppice/base/timer.h"
#include "coppice/builders/build_tree.h"
#include "coppice/geom/point_cloud.h"
#include "coppice/io/load_mesh.h"

#include "exhibits/scene_outline.h"
#include "exhibits/scene_picture.h"
#include "exhibits/tree_cells.h"
#include "experiment/protocol.h"
#include "experiment/scene_trees.h"
#include "scenes/room_view.h"
#include "tracers/memory_limit.h"

#include <fmt/format.h>

#include <algorithm>
#include <new>
#include <utility>
#include <vector>

namespace coppice::lab {

namespace {

constexpr std::uint64_t seed = 1;
constexpr std::size_t most_cells = 1000;  // of a level: more would hide each other

/// What an inspector may take of a page.
struct InspectorLimits {
    OutlineLimits outline;
    std::size_t cells = most_cells;
};

/// The limits of one of so many scenes.
InspectorLimits limits_of(std::size_t scene_count) {
    const std::size_t share = std::clamp<std::size_t>(scene_count, 1, most_inspected);
    const OutlineLimits all;
    return {{all.triangles / share, all.points / share}, most_cells / share};
}

/// Whether `candidate` is the better one to show: a smaller sample, or of equal ones the later.
bool is_preferred(const Recommendation& candidate, const Recommendation* best) {
    return best == nullptr || candidate.chosen.percent <= best->chosen.percent;
}

/// Whether it is a tree by a protocol and the usual sampler: what can be shown.
bool is_shown(const SceneResult& scene, const ExperimentOptions& options,
              const Recommendation& recommendation) {
    const auto& protocols = options.protocols;
    return recommendation.sampler == scene.rows.front().sampler &&
           std::find(protocols.begin(), protocols.end(), recommendation.protocol) !=
               protocols.end();
}

/// Chooses the trees; tells `exhibits` which.
void choose_trees(const SceneResult& scene, const ExperimentOptions& options,
                  report::SceneExhibits& exhibits) {
    const auto is_triangles = [](const ResultRow& row) { return row.primitives == "triangles"; };
    const bool has_triangles = std::any_of(scene.rows.begin(), scene.rows.end(), is_triangles);
    exhibits.kind = name_of(has_triangles ? PrimitiveKind::triangles : PrimitiveKind::points);
    const Recommendation* best = nullptr;
    for (const Recommendation& candidate : scene.recommended) {
        if (candidate.primitives == exhibits.kind && is_shown(scene, options, candidate) &&
            is_preferred(candidate, best)) {
            best = &candidate;
        }
    }
    exhibits.full.protocol = best != nullptr ? best->protocol : options.protocols.back();
    exhibits.is_recommended = best != nullptr && best->chosen.percent < all_percent;
    double percent = exhibits.is_recommended ? best->chosen.percent : 0.0;
    if (!exhibits.is_recommended) {
        for (const ResultRow& row : scene.rows) {
            if (row.sample_percent < all_percent) percent = std::max(percent, row.sample_percent);
        }
    }
    if (percent > 0.0) exhibits.other = report::TreeName{exhibits.full.protocol, percent};
}

/// Makes the exhibits of one scene, one after the other.
class ExhibitMaker {
public:
    ExhibitMaker(const SceneResult& scene, const ExperimentOptions& options,
                 report::SceneExhibits& exhibits)
        : options_(options),
          exhibits_(exhibits),
          sampler_(scene.rows.front().sampler),
          mesh_(load_mesh(scene.file, nullptr, &attributes_)) {}

    /// `with_trees`: not the picture alone.
    void make(bool with_trees) {
        const bool can_be_seen = !mesh_.triangles.empty();
        if (can_be_seen) {
            take_picture();
        } else {
            camera_ = render::frame_points(mesh_.vertices, {}, 1.0);
            exhibits_.missing = "A point cloud has no surface to take a picture of.";
        }
        if (!with_trees) {
            exhibits_.missing = fmt::format(
                "Of {} scenes on one page only the first {} have heat maps and the tree inspector: "
                "an experiment on this scene alone shows them.",
                options_.scenes.size(), most_inspected);
            return;
        }
        make_points();
        const KdTree full = build(exhibits_.full);
        KdTree other;
        if (exhibits_.other) other = build(*exhibits_.other);
        inspect(full, exhibits_.other ? &other : nullptr);
        if (!can_be_seen) return;
        if (exhibits_.kind == name_of(PrimitiveKind::triangles)) {
            exhibits_.heat_maps =
                render_heat_maps(picture_scene(), full, exhibits_.other ? &other : nullptr);
        } else {
            exhibits_.missing =
                "There are no trees of triangles here that rays could be sent through.";
        }
    }

private:
    [[nodiscard]] PictureScene picture_scene() const {
        return {mesh_.view(), &attributes_, camera_, options_.build.threads};
    }

    void take_picture() {
        const auto tracer = build_picture_tree(mesh_.view(), options_.build.threads, control());
        camera_ = choose_camera(mesh_.view(), tracer, {}, 16.0 / 9.0).camera;
        exhibits_.picture_camera = render::camera_text(camera_);
        exhibits_.picture = render_picture(picture_scene(), tracer);
    }

    void make_points() {
        if (exhibits_.kind == name_of(PrimitiveKind::points)) {
            points_ = shuffled_distinct_points(mesh_.vertices, seed);
        }
    }

    [[nodiscard]] KdTree build(const report::TreeName& name) const {
        KdOptions options =
            find_protocol(name.protocol).options(options_.build, name.percent / all_percent, seed);
        options.sample.sampler = sampler_;
        const PointCloudView points(points_);
        const TriangleMeshView triangles = mesh_.view();
        BuildControl unmeasured = control();
        unmeasured.is_measured = false;
        return points_.empty() ? build_kd_tree(triangles, options, unmeasured).tree
                               : build_kd_tree(points, options, unmeasured).tree;
    }

    [[nodiscard]] BuildControl control() const {
        return limit_memory(options_.memory_limit_bytes, mesh_.view(), points_);
    }

    void inspect(const KdTree& full, const KdTree* other) {
        const SahCostModel& cost = options_.build.cost;
        report::Inspector inspector;
        inspector.bounds = bounds_of(mesh_.vertices);
        inspector.viewpoint = {camera_.eye, camera_.look_at, camera_.up, camera_.fov};
        const InspectorLimits limits = limits_of(options_.scenes.size());
        inspector.outline = outline_of(mesh_, limits.outline);
        inspector.full = collect_cells(full, cost, limits.cells);
        if (other != nullptr) inspector.other = collect_cells(*other, cost, limits.cells);
        exhibits_.inspector = std::move(inspector);
    }

    const ExperimentOptions& options_;
    report::SceneExhibits& exhibits_;
    std::string sampler_;
    MeshAttributes attributes_;
    TriangleMesh mesh_;
    std::vector<Vec3f> points_;  // the primitives, if they are points
    render::Camera camera_;
};

}  // namespace

report::SceneExhibits make_exhibits(const SceneResult& scene, const ExperimentOptions& options,
                                    std::size_t place) {
    report::SceneExhibits exhibits;
    if (scene.rows.empty()) return exhibits;
    choose_trees(scene, options, exhibits);
    const Timer timer;
    try {
        run_with_threads(options.build.threads, [&] {
            ExhibitMaker(scene, options, exhibits).make(place < most_inspected);
        });
    } catch (const Error& error) {
        exhibits.missing = fmt::format("Some pictures could not be made: {}.", error.what());
    } catch (const std::bad_alloc&) {
        exhibits.missing = "Some pictures could not be made: there is not enough memory.";
    }
    exhibits.seconds = timer.seconds();
    return exhibits;
}

}  // namespace coppice::lab
