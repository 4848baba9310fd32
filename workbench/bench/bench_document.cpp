#include "bench/bench_results.h"
#include "rows/machine.h"

#include <nlohmann/json.hpp>

namespace coppice::lab {

namespace {

using Json = nlohmann::ordered_json;

Json number_or_null(const std::optional<double>& value) {
    return value ? Json(*value) : Json();
}

Json view_json(const BenchScene& scene) {
    Json json{{"scene", scene.scene}, {"file", scene.file.string()}};
    json["camera"] = nlohmann::json(scene.camera);
    json["light"] = {scene.light.x, scene.light.y, scene.light.z};
    json["reference"] = scene.reference;
    for (const RayKindEntry& entry : rendering_ray_kinds()) {
        json["ray_counts"][std::string(entry.name)] =
            scene.ray_counts[static_cast<std::size_t>(entry.kind)];
    }
    return json;
}

}  // namespace

Json row_json(const BenchRow& row) {
    return {{"scene", row.scene},
            {"triangles", row.triangles},
            {"method", row.method},
            {"peer", row.is_peer},
            {"threads", row.threads},
            {"build_seconds", row.build_seconds},
            {"build_seconds_first", row.build_seconds_first},
            {"build_cpu_seconds", row.build_cpu_seconds},
            {"bytes_per_triangle", row.bytes_per_triangle},
            {"peak_bytes_per_triangle", row.peak_bytes_per_triangle},
            {"sah_cost", number_or_null(row.sah_cost)},
            {"references_per_triangle", number_or_null(row.references_per_triangle)},
            {"primary_mrays", number_or_null(row.mrays[0])},
            {"shadow_mrays", number_or_null(row.mrays[1])},
            {"diffuse_mrays", number_or_null(row.mrays[2])},
            {"mismatches", row.mismatches}};
}

Json bench_document(const BenchOptions& options, const BenchResult& result) {
    Json json;
    json["machine"] = provenance_json();
    json["options"] = nlohmann::json(options);
    json["options"]["views"] = Json::array();
    for (const BenchScene& scene : result.scenes) {
        json["options"]["views"].push_back(view_json(scene));
    }
    json["rows"] = Json::array();
    for (const BenchRow& row : result.rows) {
        json["rows"].push_back(row_json(row));
    }
    // File names need not be UTF-8, JSON must be.
    return Json::parse(json.dump(-1, ' ', false, Json::error_handler_t::replace));
}

}  // namespace coppice::lab
