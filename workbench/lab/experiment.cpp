// The loops of the experiment. Rows are measured one after another, alone on the machine; between
// two builds nothing is kept but the mesh, the points of the current seed and the reports.

#include "lab/experiment.h"

#include "coppice/base/error.h"
#include "coppice/base/parallel.h"
#include "coppice/base/timer.h"
#include "coppice/geom/point_cloud.h"

#include "lab/builders.h"
#include "lab/recommend.h"
#include "lab/remaining_time.h"
#include "lab/scene_names.h"
#include "lab/scene_rays.h"
#include "lab/tree_measurement.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>

namespace coppice::lab {

namespace {

constexpr double all_percent = 100.0;

/// What is known of a scene before its trees are built.
struct SceneFile {
    std::string name;
    std::filesystem::path file;
    std::vector<PrimitiveKind> kinds;
    std::uint64_t vertex_count = 0;
    std::uint64_t triangle_count = 0;

    [[nodiscard]] double count_of(PrimitiveKind kind) const {
        return static_cast<double>(kind == PrimitiveKind::points ? vertex_count : triangle_count);
    }
};

/// What all scenes of a run share.
struct Run {
    const ExperimentOptions& options;
    const ExperimentObserver& observer;
    std::vector<Builder> builders;
    RemainingTime remaining;

    void tell(const ExperimentProgress& progress) const {
        if (observer.on_progress) observer.on_progress(progress);
    }

    void note(const std::string& text) const {
        if (observer.on_note) observer.on_note(text);
    }

    [[nodiscard]] bool lists_all_percent() const {
        return std::count(options.percents.begin(), options.percents.end(), all_percent) > 0;
    }

    /// The percentages that are rows, as asked for.
    [[nodiscard]] std::vector<double> listed(const Builder& builder) const {
        return builder.is_sampling ? options.percents : std::vector{all_percent};
    }

    /// The percentages to build, the reference first.
    [[nodiscard]] std::vector<double> build_order(const Builder& builder) const {
        std::vector<double> order = listed(builder);
        std::erase(order, all_percent);
        order.insert(order.begin(), all_percent);
        return order;
    }
};

double ratio(double value, double reference) {
    if (value == reference) return 1.0;
    return reference > 0.0 ? value / reference : std::numeric_limits<double>::quiet_NaN();
}

/// The kinds of primitives to run on a mesh: those asked for, or those that it has.
std::vector<PrimitiveKind> kinds_for(const Run& run, const std::filesystem::path& file,
                                     const TriangleMesh& mesh) {
    const auto fail = [&](const char* what) {
        throw file_error(ErrorCode::unsupported, file.string(), what);
    };
    if (mesh.vertices.empty()) fail("no vertices: there is nothing to build a tree of");
    const auto& asked = run.options.primitives;
    if (!mesh.triangles.empty()) {
        if (!asked.empty()) return asked;
        return {PrimitiveKind::points, PrimitiveKind::triangles};
    }
    if (std::count(asked.begin(), asked.end(), PrimitiveKind::triangles) > 0) {
        fail("a point cloud without triangles: ask for --primitives points");
    }
    if (asked.empty()) {
        run.note(
            fmt::format("{}: a point cloud without triangles: only points are run", file.string()));
    }
    return {PrimitiveKind::points};
}

bool is_built_over(const Builder& builder, PrimitiveKind kind) {
    return builder.form == TreeForm::kd || kind == PrimitiveKind::triangles;
}

void plan_work(Run& run, const SceneFile& scene) {
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

/// The trees that differ in their rate only: one kind, builder, sampler and seed.
struct TreeFamily {
    PrimitiveKind kind;
    const Builder& builder;
    std::string sampler;
    std::uint64_t seed;

    [[nodiscard]] std::string step(double percent) const {
        const std::string how = sampler.empty() ? std::string(builder.name)
                                                : fmt::format("{}, {}", builder.name, sampler);
        return fmt::format("{}, {}, {} %, seed {}", name_of(kind),
                           builder.samplers.size() > 1 ? how : builder.name, percent, seed);
    }
};

/// The trees of one scene.
class SceneRun {
public:
    SceneRun(Run& run, const SceneFile& scene, const TriangleMesh& mesh, SceneResult& result)
        : run_(run), scene_(scene), mesh_(mesh), result_(result) {
        for (const PrimitiveKind kind : scene.kinds) {
            for (const Builder& builder : run.builders) {
                if (!is_built_over(builder, kind)) continue;
                row_count_ += run.build_order(builder).size() * builder.samplers.size() *
                              static_cast<std::size_t>(run.options.seed_count);
            }
        }
    }

    void run_all() {
        for (const PrimitiveKind kind : scene_.kinds) {
            for (const Builder& builder : run_.builders) {
                if (is_built_over(builder, kind)) run_builder(kind, builder);
            }
        }
    }

private:
    void run_builder(PrimitiveKind kind, const Builder& builder) {
        for (const std::string& sampler : builder.samplers) {
            for (int seed = 1; seed <= run_.options.seed_count; ++seed) {
                run_rates({kind, builder, sampler, static_cast<std::uint64_t>(seed)});
            }
        }
    }

    /// The rows of one family: built with the reference first, listed as asked.
    void run_rates(const TreeFamily& family) {
        const std::vector<double> listed = run_.listed(family.builder);
        std::vector<ResultRow> rows(listed.size());
        std::vector<std::uint32_t> sample_counts;
        ResultRow reference;
        for (const double percent : run_.build_order(family.builder)) {
            ResultRow row = row_of(family, percent, measure(family, percent));
            if (percent == all_percent) reference = row;
            row.relative_cost =
                ratio(row.report.statistics.sah_cost, reference.report.statistics.sah_cost);
            row.relative_time =
                ratio(row.report.stages.wall_seconds(), reference.report.stages.wall_seconds());
            const auto place = std::find(listed.begin(), listed.end(), percent);
            if (place == listed.end() || is_known_sample(row, sample_counts)) continue;
            rows[static_cast<std::size_t>(place - listed.begin())] = std::move(row);
        }
        std::copy_if(std::make_move_iterator(rows.begin()), std::make_move_iterator(rows.end()),
                     std::back_inserter(result_.rows),
                     [](const ResultRow& row) { return !row.scene.empty(); });
    }

    /// Wide trees of small scenes are not sampled, and some have a least sample.
    static bool is_known_sample(const ResultRow& row, std::vector<std::uint32_t>& known) {
        if (row.form != TreeForm::wide) return false;
        const std::uint32_t count = row.report.sample_count;
        if (std::count(known.begin(), known.end(), count) > 0) return true;
        known.push_back(count);
        return false;
    }

    [[nodiscard]] ResultRow row_of(const TreeFamily& family, double percent,
                                   TreeFigures figures) const {
        ResultRow row;
        row.scene = scene_.name;
        row.primitives = name_of(family.kind);
        row.protocol = family.builder.name;
        row.sample_percent = percent;
        row.seed = family.seed;
        row.report = std::move(figures.report);
        row.sampler = family.sampler;
        row.form = family.builder.form;
        row.unsampled_tests = figures.unsampled_tests;
        row.rays = std::move(figures.rays);
        return row;
    }

    TreeFigures measure(const TreeFamily& family, double percent) {
        run_.tell(
            {scene_.name, family.step(percent), rows_done_, row_count_, run_.remaining.seconds()});
        const auto& [kind, builder, sampler, seed] = family;
        const BuildOptions options =
            options_of(builder, run_.options.build, sampler, percent, seed);
        const double work = work_of_build({kind, builder.name, percent, scene_.count_of(kind)});
        const RowKey key{
            scene_.name, std::string(name_of(kind)), std::string(builder.name), percent, seed,
            sampler};
        ++rows_done_;
        if (auto finished = find_finished(key, options)) {
            run_.remaining.plan(-work);
            const bool is_points = kind == PrimitiveKind::points;
            if (is_points) result_.distinct_vertex_count = finished->report.primitive_count;
            return *std::move(finished);
        }
        const PointCloudView points(points_of(kind, seed));
        const TriangleMeshView triangles = mesh_.view();
        const SceneRays* rays = rays_for(kind);
        const Timer timer;
        TreeFigures figures = measure_tree(
            builder, options,
            {kind == PrimitiveKind::points ? PrimitiveSetView(points) : PrimitiveSetView(triangles),
             triangles, rays});
        run_.remaining.finish(work, timer.seconds());
        if (run_.observer.on_row) run_.observer.on_row(key, figures);
        return figures;
    }

    [[nodiscard]] std::optional<TreeFigures> find_finished(const RowKey& key,
                                                           const BuildOptions& options) const {
        if (!run_.observer.find_finished) return std::nullopt;
        std::optional<TreeFigures> figures = run_.observer.find_finished(key);
        if (figures) figures->report.options = options;
        return figures;
    }

    /// The points of a seed; those of the last one are kept, also while triangles are built over.
    std::span<const Vec3f> points_of(PrimitiveKind kind, std::uint64_t seed) {
        if (kind != PrimitiveKind::points || points_seed_ == seed) return points_;
        points_ = {};  // freed before the next are made
        run_with_threads(run_.options.build.threads,
                         [&] { points_ = shuffled_distinct_points(mesh_.vertices, seed); });
        points_seed_ = seed;
        result_.distinct_vertex_count = points_.size();
        return points_;
    }

    /// The scene's rays, made when the first tree needs them.
    const SceneRays* rays_for(PrimitiveKind kind) {
        if (kind == PrimitiveKind::points || !result_.view) return nullptr;
        if (!rays_) {
            const ExperimentOptions& options = run_.options;
            rays_.emplace(mesh_.view(), *result_.view, options.rays, options.build.threads);
        }
        return &*rays_;
    }

    Run& run_;
    const SceneFile& scene_;
    const TriangleMesh& mesh_;
    SceneResult& result_;
    std::optional<SceneRays> rays_;
    std::vector<Vec3f> points_;  // of points_seed_
    std::uint64_t points_seed_ = 0;
    std::size_t rows_done_ = 0;
    std::size_t row_count_ = 0;
};

/// From where the rays of a scene come; nothing if there are none.
std::optional<RayOptions> view_of(const Run& run, const SceneFile& scene,
                                  const TriangleMesh& mesh) {
    const ExperimentOptions& options = run.options;
    const auto& kinds = scene.kinds;
    const bool has_triangles =
        std::find(kinds.begin(), kinds.end(), PrimitiveKind::triangles) != kinds.end();
    if (options.rays.empty() || !has_triangles) return std::nullopt;
    const Aabb box = bounds_of(mesh.vertices);
    const render::Camera camera = render::frame_box(box, options.camera, 1.0);
    return RayOptions{camera, render::place_light(camera, box), options.size, 1};
}

/// What of a scene's kinds the options cannot be applied to.
void note_what_is_left_out(const Run& run, const SceneFile& scene) {
    const bool has_triangles = std::find(scene.kinds.begin(), scene.kinds.end(),
                                         PrimitiveKind::triangles) != scene.kinds.end();
    if (has_triangles) return;
    if (!run.options.rays.empty()) {
        run.note(scene.name + ": points are not traced: there are no figures of rays");
    }
    for (const Builder& builder : run.builders) {
        if (is_built_over(builder, PrimitiveKind::points)) continue;
        run.note(fmt::format("{}: {} is built over triangles only: there are no rows of it",
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
                "{}, {}, {} %, seed {}: {} of {} {} rays hit something else than those of the "
                "reference ({})",
                row.protocol, row.sampler, row.sample_percent, row.seed, figures.mismatches,
                figures.rays, name_of(figures.kind), SceneRays::reference_method()));
        }
    }
    return errors;
}

TriangleMesh load_scene(Run& run, SceneFile& scene, LoadReport& report) {
    run.tell({scene.name, "loading", 0, 0, run.remaining.seconds()});
    return load_mesh(scene.file, &report);
}

/// Notes what is known of a loaded scene, and the work it will be.
void inspect(Run& run, SceneFile& scene, const TriangleMesh& mesh) {
    scene.kinds = kinds_for(run, scene.file, mesh);
    scene.vertex_count = mesh.vertices.size();
    scene.triangle_count = mesh.triangles.size();
    note_what_is_left_out(run, scene);
    plan_work(run, scene);
}

SceneResult run_scene(Run& run, const SceneFile& scene, const TriangleMesh& mesh,
                      LoadReport load_report) {
    SceneResult result;
    result.scene = scene.name;
    result.file = scene.file;
    result.load_report = std::move(load_report);
    result.vertex_count = scene.vertex_count;
    result.triangle_count = scene.triangle_count;
    result.bounds = bounds_of(mesh.vertices);
    result.view = view_of(run, scene, mesh);
    SceneRun(run, scene, mesh, result).run_all();
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
    Run run{options, observer, builders_of(options), {}};
    if (!run.lists_all_percent()) {
        run.note(
            "100 % is not among the rates; its tree is built all the same, as the reference "
            "of relative costs, and not listed");
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
