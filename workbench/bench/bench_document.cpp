#include "bench/bench_results.h"
#include "rows/machine.h"
#include "text/json_text.h"

#include <nlohmann/json.hpp>

namespace coppice::lab {

namespace {

using Json = nlohmann::ordered_json;

Json view_json(const BenchScene& scene) {
    Json json{{"scene", scene.scene}, {"file", scene.file.string()}};
    json["camera"] = nlohmann::json(scene.camera);
    json["light"] = vector_json(scene.light);
    json["reference"] = scene.reference;
    json["ray_counts"] = ray_counts_json(scene);
    return json;
}

}  // namespace

Json ray_counts_json(const BenchScene& scene) {
    Json json;
    for (const RayKindEntry& entry : rendering_ray_kinds()) {
        json[std::string(entry.name)] = scene.ray_counts[index_of(entry.kind)];
    }
    return json;
}

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
            {"sah_cost", number_json(row.sah_cost)},
            {"references_per_triangle", number_json(row.references_per_triangle)},
            {"primary_mrays", number_json(row.mrays[0])},
            {"shadow_mrays", number_json(row.mrays[1])},
            {"diffuse_mrays", number_json(row.mrays[2])},
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
    return as_written(json);
}

}  // namespace coppice::lab
