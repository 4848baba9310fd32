// The loops of the experiment. Rows are measured one after another, alone on the machine; between
// two builds nothing is kept but the mesh, the points of the current seed and the reports.

#include "lab/experiment.h"

#include "coppice/base/error.h"
#include "coppice/base/parallel.h"
#include "coppice/base/timer.h"
#include "coppice/build/build_tree.h"
#include "coppice/geom/point_cloud.h"

#include "lab/protocol.h"
#include "lab/recommend.h"
#include "lab/remaining_time.h"
#include "lab/scene_names.h"

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
};

/// What all scenes of a run share.
struct Run {
    const ExperimentOptions& options;
    const ExperimentObserver& observer;
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

    /// The percentages to build, the reference first.
    [[nodiscard]] std::vector<double> build_order() const {
        std::vector<double> order{all_percent};
        std::copy_if(options.percents.begin(), options.percents.end(), std::back_inserter(order),
                     [](double percent) { return percent != all_percent; });
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

void plan_work(Run& run, const SceneFile& scene) {
    for (const PrimitiveKind kind : scene.kinds) {
        const auto count =
            kind == PrimitiveKind::points ? scene.vertex_count : scene.triangle_count;
        for (const std::string& protocol : run.options.protocols) {
            for (const double percent : run.build_order()) {
                run.remaining.plan(
                    work_of_build({kind, protocol, percent, static_cast<double>(count)}) *
                    run.options.seed_count);
            }
        }
    }
}

/// The trees of one scene.
class SceneRun {
public:
    SceneRun(Run& run, const SceneFile& scene, const TriangleMesh& mesh, SceneResult& result)
        : run_(run), scene_(scene), mesh_(mesh), result_(result) {
        for (const double percent : run.options.percents) {
            listed_.push_back(percent);
        }
        row_count_ = scene.kinds.size() * run.options.protocols.size() *
                     static_cast<std::size_t>(run.options.seed_count) * run.build_order().size();
    }

    void run_all() {
        for (const PrimitiveKind kind : scene_.kinds) {
            for (const std::string& protocol : run_.options.protocols) {
                for (int seed = 1; seed <= run_.options.seed_count; ++seed) {
                    run_rates(kind, find_protocol(protocol), static_cast<std::uint64_t>(seed));
                }
            }
        }
    }

private:
    /// The rows of one kind, protocol and seed: built with the reference first, listed as asked.
    void run_rates(PrimitiveKind kind, const Protocol& protocol, std::uint64_t seed) {
        std::vector<ResultRow> rows(listed_.size());
        BuildReport reference;
        for (const double percent : run_.build_order()) {
            const BuildReport report = build(kind, protocol, seed, percent);
            if (percent == all_percent) reference = report;
            const auto place = std::find(listed_.begin(), listed_.end(), percent);
            if (place == listed_.end()) continue;
            rows[static_cast<std::size_t>(place - listed_.begin())] = {
                scene_.name,
                std::string(name_of(kind)),
                std::string(protocol.name),
                percent,
                seed,
                report,
                ratio(report.statistics.sah_cost, reference.statistics.sah_cost),
                ratio(report.stages.wall_seconds(), reference.stages.wall_seconds())};
        }
        std::move(rows.begin(), rows.end(), std::back_inserter(result_.rows));
    }

    BuildReport build(PrimitiveKind kind, const Protocol& protocol, std::uint64_t seed,
                      double percent) {
        std::string step =
            fmt::format("{}, {}, {} %, seed {}", name_of(kind), protocol.name, percent, seed);
        run_.tell({scene_.name, std::move(step), rows_done_, row_count_, run_.remaining.seconds()});
        const BuildOptions options = protocol.options(run_.options.build, percent / 100.0, seed);
        const bool is_points = kind == PrimitiveKind::points;
        const auto planned =
            static_cast<double>(is_points ? scene_.vertex_count : scene_.triangle_count);
        const double work = work_of_build({kind, std::string(protocol.name), percent, planned});
        const RowKey key{scene_.name, std::string(name_of(kind)), std::string(protocol.name),
                         percent, seed};
        if (const auto finished = find_finished(key, options)) {
            run_.remaining.plan(-work);
            if (is_points) result_.distinct_vertex_count = finished->primitive_count;
            ++rows_done_;
            return *finished;
        }
        if (is_points) update_points(seed);
        const PointCloudView points(points_);
        const TriangleMeshView triangles = mesh_.view();
        const Timer timer;
        BuildReport report;
        // The tree is freed here: only what it measured is kept.
        static_cast<void>(build_kd_tree(
            is_points ? PrimitiveSetView(points) : PrimitiveSetView(triangles), options, &report));
        run_.remaining.finish(work, timer.seconds());
        ++rows_done_;
        if (run_.observer.on_row) run_.observer.on_row(key, report);
        return report;
    }

    [[nodiscard]] std::optional<BuildReport> find_finished(const RowKey& key,
                                                           const BuildOptions& options) const {
        if (!run_.observer.find_finished) return std::nullopt;
        std::optional<BuildReport> report = run_.observer.find_finished(key);
        if (report) report->options = options;
        return report;
    }

    void update_points(std::uint64_t seed) {
        if (points_seed_ == seed) return;
        points_ = {};  // freed before the next are made
        run_with_threads(run_.options.build.threads,
                         [&] { points_ = shuffled_distinct_points(mesh_.vertices, seed); });
        points_seed_ = seed;
        result_.distinct_vertex_count = points_.size();
    }

    Run& run_;
    const SceneFile& scene_;
    const TriangleMesh& mesh_;
    SceneResult& result_;
    std::vector<double> listed_;
    std::vector<Vec3f> points_;  // of points_seed_
    std::uint64_t points_seed_ = 0;
    std::size_t rows_done_ = 0;
    std::size_t row_count_ = 0;
};

TriangleMesh load_scene(Run& run, SceneFile& scene, LoadReport& report) {
    run.tell({scene.name, "loading", 0, 0, run.remaining.seconds()});
    return load_mesh(scene.file, &report);
}

/// Notes what is known of a loaded scene, and the work it will be.
void inspect(Run& run, SceneFile& scene, const TriangleMesh& mesh) {
    scene.kinds = kinds_for(run, scene.file, mesh);
    scene.vertex_count = mesh.vertices.size();
    scene.triangle_count = mesh.triangles.size();
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
    SceneRun(run, scene, mesh, result).run_all();
    const std::vector<RateSummary> summaries = summarize_seeds(result.rows);
    result.recommended = recommend(summaries, run.options.tolerance);
    result.knees = find_knees(summaries);
    return result;
}

}  // namespace

std::vector<SceneResult> run_experiment(const ExperimentOptions& options,
                                        const ExperimentObserver& observer) {
    check(options);
    Run run{options, observer, {}};
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
