#include "rows/rays_document.h"

#include "rows/cost_prediction.h"
#include "rows/drift.h"
#include "rows/seed_summary.h"
#include "rows/time_to_image.h"
#include "text/json_text.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

namespace coppice::lab {

namespace {

using Json = nlohmann::ordered_json;

Json name_json(const ImageTree& tree) {
    return {{"protocol", tree.summary->protocol},
            {"sampler", tree.summary->sampler},
            {"sample_percent", tree.summary->sample_percent}};
}

Json tree_json(const ImageTree& tree) {
    Json json = name_json(tree);
    json["tree"] = name_of(tree.summary->form);
    json["sah_cost"] = number_json(tree.summary->sah_cost.mean);
    json["build_seconds"] = tree.time.build;
    json["ray_seconds"] = tree.time.ray;
    return json;
}

Json span_json(const ImageRace& race, const BestSpan& span) {
    Json json = name_json(race.trees[span.index]);
    json["from_rays"] = span.from;
    json["to_rays"] = number_json(span.to);
    return json;
}

Json prediction_json(const CostPrediction& prediction) {
    return {{"tree", name_of(prediction.form)},
            {"rays", prediction.rays},
            {"tree_count", prediction.tree_count},
            {"cost_with_time", number_json(prediction.with_time)},
            {"cost_with_steps", number_json(prediction.with_steps)},
            {"rule", "Spearman's rank correlation"}};
}

Json calibration_json(const FormCalibration& calibration) {
    const Calibration& found = calibration.found;
    return {
        {"tree", name_of(calibration.form)},
        {"residuals", name_of(calibration.residual)},
        {"traversal_nanoseconds", found.traversal},
        {"intersection_nanoseconds", found.intersection},
        {"traversal_error", number_json(found.traversal_error)},
        {"intersection_error", number_json(found.intersection_error)},
        {"r_squared", number_json(found.r_squared)},
        {"rms_nanoseconds", found.rms},
        {"relative_rms", found.relative_rms},
        {"count", found.count},
        {"tree_count", calibration.tree_count},
        {"is_rank_deficient", found.is_rank_deficient},
        {"caution", calibration.caution},
        {"rule", "least squares, both >= 0, of nanoseconds a ray over nodes and primitives a ray"}};
}

/// The arrays of what was found.
void put_findings(const SceneResult& scene, Json& json) {
    json["correlations"] = Json::array();
    for (const CostPrediction& prediction : find_predictions(scene.rows)) {
        json["correlations"].push_back(prediction_json(prediction));
    }
    json["calibrations"] = Json::array();
    for (const FormCalibration& calibration : find_calibrations(scene.rows)) {
        json["calibrations"].push_back(calibration_json(calibration));
    }
}

void put_race(const ImageRace& race, Json& json) {
    for (const char* key : {"trees", "fastest", "break_even"}) {
        json[key] = Json::array();
    }
    for (const ImageTree& tree : race.trees) {
        json["trees"].push_back(tree_json(tree));
    }
    for (const BestSpan& span : race.fastest) {
        json["fastest"].push_back(span_json(race, span));
    }
    for (const TreePair& pair : race.pairs) {
        json["break_even"].push_back({{"sooner", name_json(race.trees[pair.sooner])},
                                      {"later", name_json(race.trees[pair.later])},
                                      {"rays", number_json(pair.ray_count)}});
    }
}

}  // namespace

Json rays_document(const SceneResult& scene) {
    const auto traced = std::find_if(scene.rows.begin(), scene.rows.end(),
                                     [](const ResultRow& row) { return !row.rays.empty(); });
    if (traced == scene.rows.end() || !scene.view) return nullptr;
    Json json{{"camera", nlohmann::json(scene.view->camera)}};
    json["light"] = vector_json(scene.view->light);
    json["size"] = scene.view->size;
    for (const RayFigures& figures : traced->rays) {
        json["ray_counts"][std::string(name_of(figures.kind))] = figures.rays;
    }
    json["reference"] = reference_method;
    const auto [least, most] = drift_range(scene.rows);
    json["drift"] = {{"least", least}, {"most", most}};
    put_findings(scene, json);
    const std::vector<RateSummary> summaries = summarize_seeds(scene.rows);
    put_race(find_image_race(summaries), json);
    return json;
}

}  // namespace coppice::lab
