#include "rows/rays_text.h"

#include "rows/cost_prediction.h"
#include "rows/drift.h"
#include "rows/seed_summary.h"
#include "rows/time_to_image.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <optional>
#include <vector>

namespace coppice::lab {

namespace {

constexpr const char* ray_line = "  {:<26} {:>6} {:>9} {:>8} {:>8} {:>8} {:>9}  {}\n";

std::string number_text(double value) {
    if (!std::isfinite(value)) return "-";
    return value < 1e6 ? fmt::format("{:.{}f}", value, value < 1000.0 ? 2 : 0)
                       : fmt::format("{:.3g}", value);
}

/// "grown", or "grown, weighted" where that tells it from others.
std::string tree_name(const RateSummary& summary) {
    return summary.sampler.empty() ? summary.protocol
                                   : fmt::format("{}, {}", summary.protocol, summary.sampler);
}

/// Steps of all rays of all seeds of one summary; nothing for peers.
std::optional<MeanSteps> steps_of(const SceneResult& scene, const RateSummary& summary) {
    MeanSteps sum;
    double count = 0.0;
    for (const ResultRow& row : scene.rows) {
        const bool is_of_summary =
            row.series() == summary.series() && row.sample_percent == summary.sample_percent;
        if (!is_of_summary) continue;
        for (const RayFigures& figures : row.rays) {
            if (!figures.steps) return std::nullopt;
            const auto rays = static_cast<double>(figures.rays);
            sum.nodes += rays * figures.steps->nodes;
            sum.leaves += rays * figures.steps->leaves;
            sum.primitives += rays * figures.steps->primitives;
            count += rays;
        }
    }
    return MeanSteps{sum.nodes / count, sum.leaves / count, sum.primitives / count};
}

/// The numbers of rays of each kind: "65536 primary, 65536 shadow".
std::string ray_counts(const std::vector<RayFigures>& rays) {
    std::string text;
    for (const RayFigures& figures : rays) {
        text +=
            fmt::format("{}{} {}", text.empty() ? "" : ", ", figures.rays, name_of(figures.kind));
    }
    return text;
}

std::string tree_lines(const SceneResult& scene, const ImageRace& race) {
    std::string text = fmt::format(ray_line, "", "%", "cost", "nodes", "leaves", "tests",
                                   "ns a ray", "fastest, with its building");
    for (std::size_t i = 0; i < race.trees.size(); ++i) {
        const RateSummary& summary = *race.trees[i].summary;
        const auto steps = steps_of(scene, summary);
        const auto step_text = [&](double MeanSteps::*member) {
            return steps ? number_text((*steps).*member) : std::string("-");
        };
        const auto span = std::find_if(race.fastest.begin(), race.fastest.end(),
                                       [&](const BestSpan& best) { return best.index == i; });
        text += fmt::format(ray_line, tree_name(summary), summary.sample_percent,
                            number_text(summary.sah_cost.mean), step_text(&MeanSteps::nodes),
                            step_text(&MeanSteps::leaves), step_text(&MeanSteps::primitives),
                            number_text(summary.ray_nanoseconds->mean),
                            span == race.fastest.end() ? "" : span_text(*span));
    }
    return text;
}

std::string correlation_text(const std::optional<double>& correlation) {
    return correlation ? fmt::format("{:.3f}", *correlation) : "not defined";
}

std::string prediction_lines(const SceneResult& scene) {
    std::string text;
    for (const CostPrediction& prediction : find_predictions(scene.rows)) {
        text += fmt::format(
            "  {} trees, {} rays: {} with the time of a ray, {} with its counted steps ({} "
            "trees)\n",
            name_of(prediction.form), prediction.rays, correlation_text(prediction.with_time),
            correlation_text(prediction.with_steps), prediction.tree_count);
    }
    return text;
}

std::string error_text(const std::optional<double>& error) {
    return error ? fmt::format("{:.2g}", *error) : "-";
}

/// What turns with the reference took out of the times.
std::string drift_line(const SceneResult& scene) {
    constexpr double too_much = 1.5;
    const auto [least, most] = drift_range(scene.rows);
    const bool is_disturbed = most > too_much || least < 1.0 / too_much;
    return fmt::format(
        "times are medians of turns with the tree `{}`, which meanwhile took {:.2f} to {:.2f} "
        "times as long as usual: this is taken out{}\n",
        reference_method, least, most,
        is_disturbed ? ", but the machine is too busy for times to be relied on" : "");
}

std::string calibration_lines(const SceneResult& scene) {
    std::string text;
    for (const auto& [form, residual, found, tree_count, caution] : find_calibrations(scene.rows)) {
        text += fmt::format(
            "  {} trees, {} residuals: t_trav = {:.3g} ns, t_isect = {:.3g} ns; R^2 = {}, RMS = "
            "{:.3g} ns or {:.3g} % of each, n = {} of {} different trees; standard errors {} and "
            "{} "
            "ns\n",
            name_of(form), name_of(residual), found.traversal, found.intersection,
            found.r_squared ? fmt::format("{:.4f}", *found.r_squared) : "not defined", found.rms,
            100.0 * found.relative_rms, found.count, tree_count, error_text(found.traversal_error),
            error_text(found.intersection_error));
        if (!caution.empty()) text += fmt::format("    {}\n", caution);
    }
    return text;
}

}  // namespace

std::string rays_text(const SceneResult& scene) {
    const auto traced = std::find_if(scene.rows.begin(), scene.rows.end(),
                                     [](const ResultRow& row) { return !row.rays.empty(); });
    if (traced == scene.rows.end()) return {};
    const std::vector<RateSummary> summaries = summarize_seeds(scene.rows);
    const ImageRace race = find_image_race(summaries);
    return fmt::format(
        "{}, rays through each tree of triangles (points are not traced): {}\n{}{}"
        "cost as a prediction (Spearman's rank correlation):\n{}"
        "t_trav and t_isect of this machine (least squares, >= 0; wall clock on all "
        "threads; the tests of an 8-wide tree are of 8 triangles):\n{}",
        scene.scene, ray_counts(traced->rays), tree_lines(scene, race), drift_line(scene),
        prediction_lines(scene), calibration_lines(scene));
}

}  // namespace coppice::lab
