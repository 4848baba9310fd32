// Trees are measured one after another. Between two builds only the mesh, the rays, the points of
// the current seed and the figures are in memory.

#include "experiment/scene_trees.h"

#include "coppice/base/error.h"
#include "coppice/base/parallel.h"
#include "coppice/base/timer.h"
#include "coppice/geom/point_cloud.h"

#include "experiment/build_work.h"
#include "experiment/scene_rays.h"
#include "experiment/tree_measurement.h"
#include "rows/recommend.h"
#include "rows/seed_summary.h"
#include "tracers/memory_limit.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <limits>
#include <optional>
#include <utility>

namespace coppice::lab {

namespace {

double ratio(double value, double reference) {
    if (value == reference) return 1.0;
    return reference > 0.0 ? value / reference : std::numeric_limits<double>::quiet_NaN();
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
    SceneRun(ExperimentRun& run, const SceneFile& scene, const TriangleMesh& mesh,
             SceneResult& result)
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
                if (!is_built_over(builder, kind)) continue;
                run_builder(kind, builder);
                tell_rows();
            }
        }
    }

private:
    void tell_rows() {
        if (!run_.observer.on_builder) return;
        result_.recommended = recommend(summarize_seeds(result_.rows), run_.options.tolerance);
        run_.observer.on_builder(result_);
    }

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
        std::string left_out;
        ResultRow reference;  // its costs stay NaN if it cannot be built: so do the relative ones
        reference.report.statistics.sah_cost = std::numeric_limits<double>::quiet_NaN();
        reference.report.stages.build.wall_seconds = std::numeric_limits<double>::quiet_NaN();
        for (const double percent : run_.build_order(family.builder)) {
            std::optional<TreeFigures> figures = measure_or_fail(family, percent);
            if (!figures) continue;
            ResultRow row = row_of(family, percent, *std::move(figures));
            if (percent == all_percent) reference = row;
            row.relative_cost =
                ratio(row.report.statistics.sah_cost, reference.report.statistics.sah_cost);
            row.relative_time =
                ratio(row.report.stages.wall_seconds(), reference.report.stages.wall_seconds());
            const auto place = std::find(listed.begin(), listed.end(), percent);
            if (place == listed.end()) continue;
            if (is_known_sample(row, sample_counts)) {
                left_out += fmt::format("{}{} %", left_out.empty() ? "" : ", ", percent);
                continue;
            }
            rows[static_cast<std::size_t>(place - listed.begin())] = std::move(row);
        }
        if (is_sampled(rows) || family.sampler == family.builder.samplers.front()) {
            std::copy_if(std::make_move_iterator(rows.begin()), std::make_move_iterator(rows.end()),
                         std::back_inserter(result_.rows),
                         [](const ResultRow& row) { return !row.scene.empty(); });
        } else if (family.seed == 1) {
            run_.note(fmt::format(
                "{}: {} does not sample this scene, so there are no rows for sampler {}",
                scene_.name, family.builder.name, family.sampler));
        }
        if (left_out.empty() || family.seed > 1) return;
        run_.note(fmt::format(
            "{}: {} draws the same sample at {} as at another rate; only the other has rows",
            scene_.name, family.builder.name, left_out));
    }

    /// False for the 8-wide trees of small scenes, which are the same with any sampler.
    static bool is_sampled(std::span<const ResultRow> rows) {
        return std::any_of(rows.begin(), rows.end(), [](const ResultRow& row) {
            return !row.scene.empty() && (row.form != TreeForm::bvh8 ||
                                          row.report.sample_count < row.report.primitive_count);
        });
    }

    /// 8-wide trees of small scenes are not sampled, and some have a least sample.
    static bool is_known_sample(const ResultRow& row, std::vector<std::uint32_t>& known) {
        if (row.form != TreeForm::bvh8) return false;
        const std::uint32_t count = row.report.sample_count;
        if (std::count(known.begin(), known.end(), count) > 0) return true;
        known.push_back(count);
        return false;
    }

    [[nodiscard]] TreeKey key_of(const TreeFamily& family, double percent) const {
        return {
            {std::string(name_of(family.kind)), std::string(family.builder.name), family.sampler},
            scene_.name,
            percent,
            family.seed};
    }

    [[nodiscard]] ResultRow row_of(const TreeFamily& family, double percent,
                                   TreeFigures figures) const {
        ResultRow row{key_of(family, percent)};
        row.report = std::move(figures.report);
        row.form = family.builder.form;
        row.unsampled_tests = figures.unsampled_tests;
        row.rays = std::move(figures.rays);
        return row;
    }

    /// The figures of a tree, or nothing if its build would pass a limit. That is noted, and the
    /// experiment continues.
    std::optional<TreeFigures> measure_or_fail(const TreeFamily& family, double percent) {
        try {
            return measure(family, percent);
        } catch (const Error& error) {
            if (error.code() != ErrorCode::limit) throw;
            result_.failures.push_back(fmt::format("{}: {}", family.step(percent), error.what()));
            run_.note(
                fmt::format("{}, {}; this tree has no row", scene_.name, result_.failures.back()));
            run_.remaining.plan(-work_of(family, percent));
            return std::nullopt;
        }
    }

    [[nodiscard]] double work_of(const TreeFamily& family, double percent) const {
        return work_of_build(
            {family.kind, family.builder.name, percent, scene_.count_of(family.kind)});
    }

    TreeFigures measure(const TreeFamily& family, double percent) {
        run_.tell(
            {scene_.name, family.step(percent), rows_done_, row_count_, run_.remaining.seconds()});
        const auto& [kind, builder, sampler, seed] = family;
        const BuildOptions options =
            options_of(builder, run_.options.build, sampler, percent, seed);
        const double work = work_of(family, percent);
        const TreeKey key = key_of(family, percent);
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
             triangles, rays, control()});
        run_.remaining.finish(work, timer.seconds());
        if (run_.observer.on_row) run_.observer.on_row(key, figures);
        return figures;
    }

    [[nodiscard]] std::optional<TreeFigures> find_finished(const TreeKey& key,
                                                           const BuildOptions& options) const {
        if (!run_.observer.find_finished) return std::nullopt;
        std::optional<TreeFigures> figures = run_.observer.find_finished(key);
        if (figures) figures->report.options = options;
        return figures;
    }

    /// The points of a seed; those of the last one are kept, also while triangles are built over.
    std::span<const Vec3f> points_of(PrimitiveKind kind, std::uint64_t seed) {
        if (kind != PrimitiveKind::points || points_seed_ == seed) return points_;
        std::vector<Vec3f>().swap(points_);  // freed before the next are made
        run_with_threads(run_.options.build.threads,
                         [&] { points_ = shuffled_distinct_points(mesh_.vertices, seed); });
        points_seed_ = seed;
        result_.distinct_vertex_count = points_.size();
        return points_;
    }

    /// The memory limit, with the mesh and the points counted in.
    [[nodiscard]] BuildControl control() const {
        return limit_memory(run_.options.memory_limit_bytes, mesh_.view(), points_);
    }

    /// The scene's rays, made when the first tree needs them.
    const SceneRays* rays_for(PrimitiveKind kind) {
        if (kind == PrimitiveKind::points || !result_.view) return nullptr;
        if (!rays_) {
            const ExperimentOptions& options = run_.options;
            rays_.emplace(mesh_.view(), *result_.view, options.rays, options.build.threads,
                          control());
        }
        return &*rays_;
    }

    ExperimentRun& run_;
    const SceneFile& scene_;
    const TriangleMesh& mesh_;
    SceneResult& result_;
    std::optional<SceneRays> rays_;
    std::vector<Vec3f> points_;  // of points_seed_
    std::uint64_t points_seed_ = 0;
    std::size_t rows_done_ = 0;
    std::size_t row_count_ = 0;
};

}  // namespace

void run_scene_trees(ExperimentRun& run, const SceneFile& scene, const TriangleMesh& mesh,
                     SceneResult& result) {
    SceneRun(run, scene, mesh, result).run_all();
}

}  // namespace coppice::lab
