// What a run of `coppice trace` writes as JSON.

#include "coppice/json/build_options.h"

#include "rows/machine.h"
#include "statistics/percentile.h"
#include "text/json_text.h"
#include "verify/trace_results.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <numeric>

namespace coppice::lab {

namespace {

using Json = nlohmann::ordered_json;

Json distribution_json(const Distribution& of) {
    return {{"mean", of.mean}, {"p50", of.p50}, {"p90", of.p90}, {"p99", of.p99}, {"max", of.max}};
}

Json answer_json(const Hit& hit, RayKind kind, bool is_right) {
    Json json{{"hit", hit.is_hit()}};
    if (kind != RayKind::shadow) {
        json["prim"] = hit.is_hit() ? Json(hit.prim) : Json();
        json["t"] = number_json(hit.t);
    }
    json["right"] = is_right;
    return json;
}

Json difference_json(const TraceDifference& difference, RayKind kind) {
    const Ray& ray = difference.ray;
    Json json{
        {"index", difference.index},
        {"origin", vector_json(ray.origin)},
        {"direction", vector_json(ray.direction)},
        {"t_min", number_json(ray.t_min)},
        {"t_max", number_json(ray.t_max)},
        {"ours", answer_json(difference.ours, kind, difference.is_ours_right)},
        {"reference", answer_json(difference.reference, kind, difference.is_reference_right)}};
    json["exact"] = {{"hit", difference.exact.has_value()}};
    if (difference.exact) {
        json["exact"]["prim"] = difference.exact->prim;
        json["exact"]["t"] = difference.exact->t;
    }
    return json;
}

Json comparison_json(const TraceComparison& with, RayKind kind) {
    Json json{{"ties", with.ties},
              {"hit_miss", with.hit_miss},
              {"distance", with.distance},
              {"ours_right", with.ours_right},
              {"reference_right", with.reference_right},
              {"ours_wrong", with.ours_wrong},
              {"examples", Json::array()}};
    for (const TraceDifference& difference : with.examples) {
        json["examples"].push_back(difference_json(difference, kind));
    }
    return json;
}

Json row_json(const TraceRow& row) {
    Json json{{"kind", name_of(row.kind)},
              {"rays", row.rays},
              {"hits", row.hits},
              {"seconds", row.seconds},
              {"mrays", row.seconds > 0.0 ? Json(1e-6 * static_cast<double>(row.rays) / row.seconds)
                                          : Json()}};
    if (row.counts) {
        json["counts"] = {{"nodes", distribution_json(row.counts->nodes)},
                          {"leaves", distribution_json(row.counts->leaves)},
                          {"primitives", distribution_json(row.counts->primitives)}};
    }
    if (row.comparison) json["comparison"] = comparison_json(*row.comparison, row.kind);
    return json;
}

Json scene_json(const TraceScene& scene) {
    Json json{{"scene", scene.scene},
              {"file", scene.file.string()},
              {"triangles", scene.triangles},
              {"method", scene.method},
              {"build_seconds", scene.build_seconds}};
    json["camera"] = nlohmann::json(scene.camera);
    json["light"] = vector_json(scene.light);
    json["rows"] = Json::array();
    for (const TraceRow& row : scene.rows) {
        json["rows"].push_back(row_json(row));
    }
    return json;
}

Json options_json(const TraceOptions& options) {
    Json json{{"method", options.method}, {"check", name_of(options.check)},
              {"count", options.counts},  {"size", options.size},
              {"seed", options.seed},     {"rays", Json::array()}};
    for (const RayKind kind : options.rays) {
        json["rays"].push_back(name_of(kind));
    }
    json["build"] = nlohmann::json(options.build);
    if (!options.tree.empty()) {
        json["method"] = nullptr;
        json["build"] = nullptr;
        json["tree"] = options.tree.string();
    }
    return json;
}

}  // namespace

Distribution distribution_of(std::span<std::uint32_t> numbers) {
    const double sum = std::accumulate(numbers.begin(), numbers.end(), 0.0);
    std::sort(numbers.begin(), numbers.end());
    return {sum / static_cast<double>(numbers.size()), percentile_of(numbers, 50),
            percentile_of(numbers, 90), percentile_of(numbers, 99), numbers.back()};
}

Json trace_document(const TraceOptions& options, std::span<const TraceScene> scenes) {
    Json json;
    json["machine"] = provenance_json();
    json["options"] = options_json(options);
    json["scenes"] = Json::array();
    for (const TraceScene& scene : scenes) {
        json["scenes"].push_back(scene_json(scene));
    }
    return as_written(json);
}

}  // namespace coppice::lab
