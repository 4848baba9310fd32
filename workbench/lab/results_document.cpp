#include "lab/results_document.h"

#include "lab/machine.h"
#include "lab/mesh_summary.h"

#include <fmt/chrono.h>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <chrono>

namespace coppice::lab {

namespace {

using Json = nlohmann::ordered_json;

std::string utc_now() {
    const auto now = std::chrono::system_clock::to_time_t(std::chrono::system_clock::now());
    return fmt::format("{:%Y-%m-%dT%H:%M:%SZ}", fmt::gmtime(now));
}

Json details_json(const ResultRow& row) {
    const TreeStatistics& statistics = row.report.statistics;
    return {{"primitives", row.primitives},
            {"protocol", row.protocol},
            {"sample_percent", row.sample_percent},
            {"seed", row.seed},
            {"expected_inner_visits", statistics.expected_inner_visits},
            {"expected_leaf_visits", statistics.expected_leaf_visits},
            {"expected_primitive_tests", statistics.expected_primitive_tests},
            {"depth_histogram", statistics.depth_histogram},
            {"cost_share_by_depth", statistics.cost_share_by_depth}};
}

Json recommendation_json(const Recommendation& recommendation) {
    return {{"primitives", recommendation.primitives},
            {"protocol", recommendation.protocol},
            {"sample_percent", recommendation.chosen.percent},
            {"relative_cost", recommendation.chosen.cost},
            {"relative_time", recommendation.chosen.time},
            {"rule", knee_rule},
            {"source", knee_source}};
}

Json scene_json(const SceneResult& scene) {
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
    json["recommended"] = Json::array();
    for (const ResultRow& row : scene.rows) {
        json["rows"].push_back(row_json(row));
        json["details"].push_back(details_json(row));
    }
    for (const Recommendation& recommendation : scene.recommended) {
        json["recommended"].push_back(recommendation_json(recommendation));
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
        json["scenes"].push_back(scene_json(scene));
    }
    // File names need not be UTF-8, JSON must be; numbers that are not finite become null.
    return Json::parse(json.dump(-1, ' ', false, Json::error_handler_t::replace));
}

}  // namespace coppice::lab
