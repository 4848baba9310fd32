#include "experiment/results_document.h"

#include "coppice/json/load_report.h"
#include "coppice/json/tree_statistics.h"

#include "rows/cost_decomposition.h"
#include "rows/machine.h"
#include "rows/rays_document.h"
#include "rows/recommend.h"
#include "rows/seed_summary.h"
#include "scenes/mesh_summary.h"
#include "text/json_text.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace coppice::lab {

namespace {

using Json = nlohmann::ordered_json;

/// What an object about trees of a series starts with.
Json rate_json(const TreeSeries& series, double percent) {
    return {{"primitives", series.primitives},
            {"protocol", series.protocol},
            {"sampler", series.sampler},
            {"sample_percent", percent}};
}

Json details_json(const ResultRow& row) {
    const TreeStatistics& statistics = row.report.statistics;
    Json json = rate_json(row, row.sample_percent);
    json.update({{"seed", row.seed},
                 {"tree", name_of(row.form)},
                 {"expected_inner_visits", statistics.expected_inner_visits},
                 {"expected_leaf_visits", statistics.expected_leaf_visits},
                 {"expected_primitive_tests", statistics.expected_primitive_tests},
                 {"unsampled_tests", row.unsampled_tests},
                 {"depth_histogram", statistics.depth_histogram},
                 {"cost_share_by_depth", statistics.cost_share_by_depth}});
    return json;
}

Json recommendation_json(const Recommendation& recommendation, std::string_view rule,
                         std::string_view source) {
    Json json = rate_json(recommendation, recommendation.chosen.percent);
    json.update({{"relative_cost", recommendation.chosen.cost},
                 {"relative_time", recommendation.chosen.time},
                 {"rule", rule},
                 {"source", source}});
    if (rule == knee_rule) return json;
    json["saves_time"] = recommendation.saves_time();
    if (const auto& interval = recommendation.relative_time) {
        json["relative_time_interval"] = {interval->low, interval->high};
    }
    return json;
}

Json seed_mean_json(const SeedMean& measure) {
    Json json{{"mean", measure.mean}};
    if (measure.interval) {
        json["low"] = measure.interval->low;
        json["high"] = measure.interval->high;
    }
    return json;
}

Json summary_json(const RateSummary& summary) {
    Json json = rate_json(summary, summary.sample_percent);
    json.update({{"seed_count", summary.seed_count},
                 {"interval", interval_name},
                 {"sah_cost", seed_mean_json(summary.sah_cost)},
                 {"relative_cost", seed_mean_json(summary.relative_cost)},
                 {"total_seconds", seed_mean_json(summary.total_seconds)},
                 {"relative_time", seed_mean_json(summary.relative_time)}});
    return json;
}

Json parts_json(const CostParts& parts) {
    Json json = rate_json(parts, parts.sample_percent);
    json.update({{"seed", parts.seed},
                 {"excess", parts.excess},
                 {"early_stop", parts.early_stop},
                 {"empty_cells", parts.empty_cells},
                 {"duplicates", parts.duplicates},
                 {"plane_error", parts.plane_error},
                 {"uneven_leaves", parts.uneven_leaves}});
    return json;
}

Json scene_json(const ExperimentOptions& options, const SceneResult& scene) {
    Json json{{"scene", scene.scene},
              {"file", scene.file.string()},
              {"vertex_count", scene.vertex_count},
              {"triangle_count", scene.triangle_count}};
    if (scene.distinct_vertex_count > 0) {
        json["distinct_vertex_count"] = scene.distinct_vertex_count;
    }
    json["bounds"] = bounds_json(scene.bounds);
    json["load_report"] = nlohmann::json(scene.load_report);
    json["rows"] = Json::array();
    json["details"] = Json::array();
    json["summary"] = Json::array();
    json["recommended"] = Json::array();
    json["knees"] = Json::array();
    for (const ResultRow& row : scene.rows) {
        json["rows"].push_back(row_json(row, options.rays));
        json["details"].push_back(details_json(row));
    }
    for (const RateSummary& summary : summarize_seeds(scene.rows)) {
        json["summary"].push_back(summary_json(summary));
    }
    const std::string rule = recommendation_rule(options.tolerance, options.seed_count);
    for (const Recommendation& recommendation : scene.recommended) {
        json["recommended"].push_back(recommendation_json(recommendation, rule, "Student 1908"));
    }
    for (const Recommendation& knee : scene.knees) {
        json["knees"].push_back(recommendation_json(knee, knee_rule, knee_source));
    }
    json["decomposition"] = Json::array();
    for (const CostParts& parts : decompose_costs(scene.rows)) {
        json["decomposition"].push_back(parts_json(parts));
    }
    if (options.memory_limit_bytes > 0) json["failures"] = scene.failures;
    if (!options.rays.empty()) {
        json["rays"] = rays_document(scene);
        json["errors"] = scene.errors;
    }
    return json;
}

}  // namespace

Json results_document(const ExperimentOptions& options, std::span<const SceneResult> scenes,
                      const std::vector<std::string>& command) {
    Json json{{"coppice", coppice_version()},
              {"created", utc_now()},
              {"git_revision", git_revision()},
              {"compiler", compiler_name()},
              {"build_type", build_type()},
              {"flags", compiler_flags()},
              {"command", command}};
    json["machine"] = nlohmann::json(find_machine());
    json["options"] = nlohmann::json(options);
    json["scenes"] = Json::array();
    for (const SceneResult& scene : scenes) {
        json["scenes"].push_back(scene_json(options, scene));
    }
    return as_written(json);
}

}  // namespace coppice::lab
