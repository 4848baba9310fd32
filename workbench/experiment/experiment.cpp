// Scene after scene: loading, planning, the trees (scene_trees.cpp), and what is found from them.

#include "experiment/experiment.h"

#include "coppice/base/error.h"

#include "experiment/build_work.h"
#include "experiment/builders.h"
#include "experiment/scene_rays.h"
#include "experiment/scene_trees.h"
#include "rows/drift.h"
#include "rows/recommend.h"
#include "scenes/room_view.h"
#include "scenes/scene_names.h"

#include <fmt/format.h>

#include <algorithm>

namespace coppice::lab {

namespace {

/// The kinds of primitives to run on a mesh: those asked for, or those that it has.
std::vector<PrimitiveKind> kinds_for(const ExperimentRun& run, const std::filesystem::path& file,
                                     const TriangleMesh& mesh) {
    const auto fail = [&](const char* what) {
        throw file_error(ErrorCode::unsupported, file.string(), what);
    };
    if (mesh.vertices.empty()) fail("has no vertices to build a tree over");
    const auto& asked = run.options.primitives;
    if (!mesh.triangles.empty()) {
        if (!asked.empty()) return asked;
        return {PrimitiveKind::points, PrimitiveKind::triangles};
    }
    if (std::count(asked.begin(), asked.end(), PrimitiveKind::triangles) > 0) {
        fail("is a point cloud without triangles; use --primitives points");
    }
    if (asked.empty()) {
        run.note(fmt::format("{}: is a point cloud without triangles: only points are run",
                             file.string()));
    }
    return {PrimitiveKind::points};
}

void plan_work(ExperimentRun& run, const SceneFile& scene) {
    for (const PrimitiveKind kind : scene.kinds) {
        const double count = scene.count_of(kind);
        for (const Builder& builder : run.builders) {
            if (!is_built_over(builder, kind)) continue;
            for (const double percent : run.build_order(builder)) {
                const double work = work_of_build({kind, builder.name, percent, count});
                run.remaining.plan(work * run.options.seed_count *
                                   static_cast<double>(builder.samplers.size()));
            }
        }
    }
}

/// From where the rays of a scene come; nothing if there are none.
std::optional<RayOptions> view_of(const ExperimentRun& run, const SceneFile& scene,
                                  const TriangleMesh& mesh) {
    const ExperimentOptions& options = run.options;
    const auto& kinds = scene.kinds;
    const bool has_triangles =
        std::find(kinds.begin(), kinds.end(), PrimitiveKind::triangles) != kinds.end();
    if (options.rays.empty() || !has_triangles) return std::nullopt;
    const Aabb box = bounds_of(mesh.vertices);
    const render::Camera camera =
        choose_ray_camera(mesh.view(), options.camera, options.build.threads);
    return RayOptions{camera, render::place_light(camera, box), options.size, 1};
}

/// What of a scene's kinds the options cannot be applied to.
void note_what_is_left_out(const ExperimentRun& run, const SceneFile& scene) {
    const bool has_triangles = std::find(scene.kinds.begin(), scene.kinds.end(),
                                         PrimitiveKind::triangles) != scene.kinds.end();
    if (has_triangles) return;
    if (!run.options.rays.empty()) {
        run.note(scene.name +
                 ": rays are traced through triangles only, so this scene has no ray figures");
    }
    for (const Builder& builder : run.builders) {
        if (is_built_over(builder, PrimitiveKind::points)) continue;
        run.note(fmt::format("{}: {} is built over triangles only, so it has no rows here",
                             scene.name, builder.name));
    }
}

/// Hits that differ from the reference's are our error, unless a peer finds them.
std::vector<std::string> find_errors(const SceneResult& scene) {
    std::vector<std::string> errors;
    for (const ResultRow& row : scene.rows) {
        for (const RayFigures& figures : row.rays) {
            if (figures.mismatches == 0 || row.form == TreeForm::peer) continue;
            errors.push_back(fmt::format(
                "{}, {}, {} %, seed {}: {} of {} {} rays hit at another distance than with the "
                "reference tree ({})",
                row.protocol, row.sampler, row.sample_percent, row.seed, figures.mismatches,
                figures.rays, name_of(figures.kind), reference_method));
        }
    }
    return errors;
}

TriangleMesh load_scene(ExperimentRun& run, SceneFile& scene, LoadReport& report) {
    run.tell({scene.name, "loading", 0, 0, run.remaining.seconds()});
    return load_mesh(scene.file, &report);
}

/// Notes what is known of a loaded scene, and the work it will be.
void inspect(ExperimentRun& run, SceneFile& scene, const TriangleMesh& mesh) {
    scene.kinds = kinds_for(run, scene.file, mesh);
    scene.vertex_count = mesh.vertices.size();
    scene.triangle_count = mesh.triangles.size();
    note_what_is_left_out(run, scene);
    plan_work(run, scene);
}

SceneResult run_scene(ExperimentRun& run, const SceneFile& scene, const TriangleMesh& mesh,
                      LoadReport load_report) {
    SceneResult result;
    result.scene = scene.name;
    result.file = scene.file;
    result.load_report = std::move(load_report);
    result.vertex_count = scene.vertex_count;
    result.triangle_count = scene.triangle_count;
    result.bounds = bounds_of(mesh.vertices);
    result.view = view_of(run, scene, mesh);
    run_scene_trees(run, scene, mesh, result);
    remove_drift(result.rows);
    result.errors = find_errors(result);
    for (const std::string& error : result.errors) {
        run.note("ERROR: " + scene.name + ": " + error);
    }
    const std::vector<RateSummary> summaries = summarize_seeds(result.rows);
    result.recommended = recommend(summaries, run.options.tolerance);
    result.knees = find_knees(summaries);
    return result;
}

}  // namespace

std::vector<SceneResult> run_experiment(const ExperimentOptions& options,
                                        const ExperimentObserver& observer) {
    check(options);
    ExperimentRun run{options, observer, builders_of(options), {}};
    if (!run.lists_all_percent()) {
        run.note(
            "100 % is not among the rates; its tree is built as the reference of relative "
            "costs, but not listed");
    }
    const std::vector<std::string> names = scene_names(options.scenes);
    std::vector<SceneFile> scenes;
    for (std::size_t i = 0; i < names.size(); ++i) {
        scenes.push_back({names[i], options.scenes[i], {}, 0, 0});
    }
    const bool has_several = scenes.size() > 1;
    LoadReport load_report;
    for (SceneFile& scene : scenes) {
        if (has_several) inspect(run, scene, load_scene(run, scene, load_report));
    }
    std::vector<SceneResult> results;
    for (SceneFile& scene : scenes) {
        const TriangleMesh mesh = load_scene(run, scene, load_report);
        if (!has_several) inspect(run, scene, mesh);
        results.push_back(run_scene(run, scene, mesh, std::move(load_report)));
        load_report = {};
        if (observer.on_scene) observer.on_scene(results.back());
    }
    return results;
}

}  // namespace coppice::lab
