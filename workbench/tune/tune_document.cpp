#include "rows/machine.h"
#include "text/json_text.h"
#include "tune/tune.h"

#include <nlohmann/json.hpp>

namespace coppice::lab {

namespace {

using Json = nlohmann::ordered_json;

Json row_json(const TuneOptions& options, const TuneRow& row) {
    Json json{{"method", row.method},
              {"sample_percent", row.sample_percent},
              {"threads", row.measured.threads},
              {"build_seconds", row.time.build},
              {"build_seconds_first", row.measured.build_seconds_first},
              {"scatter", row.measured.scatter},
              {"build_cpu_seconds", row.measured.build_cpu_seconds}};
    for (const RayKindEntry& entry : rendering_ray_kinds()) {
        const auto& seconds = row.ray_seconds[index_of(entry.kind)];
        json[std::string(entry.name) + "_ray_seconds"] = number_json(seconds);
    }
    json["ray_seconds"] = row.time.ray;
    json["total_seconds"] = row.time.seconds(options.ray_count);
    json["sah_cost"] = number_json(row.measured.sah_cost);
    json["bytes_per_triangle"] = row.measured.bytes_per_triangle;
    json["mismatches"] = row.measured.mismatches;
    return json;
}

Json name_json(const TuneRow& row) {
    return {{"method", row.method}, {"sample_percent", row.sample_percent}};
}

/// Each pair with a break-even: the one that builds sooner, the one that traces faster, from where.
Json break_even_json(const std::vector<TuneRow>& rows) {
    Json pairs = Json::array();
    for (const TuneRow& sooner : rows) {
        for (const TuneRow& later : rows) {
            const auto ray_count = break_even(sooner.time, later.time);
            if (!ray_count || !(sooner.time.build < later.time.build)) continue;
            pairs.push_back({{"sooner", name_json(sooner)},
                             {"later", name_json(later)},
                             {"rays", number_json(*ray_count)}});
        }
    }
    return pairs;
}

Json result_json(const TuneOptions& options, const TuneResult& result) {
    const BenchScene& scene = result.scene;
    Json json{{"scene", scene.scene},
              {"file", scene.file.string()},
              {"triangles", scene.triangles},
              {"answer", tune_sentence(options, result)},
              {"recommended", row_json(options, result.rows[result.chosen])},
              {"rows", Json::array()},
              {"fastest", Json::array()}};
    for (const TuneRow& row : result.rows) {
        json["rows"].push_back(row_json(options, row));
    }
    for (const BestSpan& span : result.fastest) {
        Json best = name_json(result.rows[span.index]);
        best["from_rays"] = span.from;
        best["to_rays"] = number_json(span.to);
        json["fastest"].push_back(best);
    }
    json["break_even"] = break_even_json(result.rows);
    json["camera"] = nlohmann::json(scene.camera);
    json["light"] = vector_json(scene.light);
    json["ray_counts"] = ray_counts_json(scene);
    return json;
}

Json options_json(const TuneOptions& options) {
    Json json{{"rays", options.ray_count}, {"methods", options.methods},
              {"rates", options.percents}, {"threads", options.threads},
              {"runs", options.runs},      {"size", options.size},
              {"seed", options.seed},      {"kinds", Json::array()}};
    if (options.memory_limit_bytes > 0) json["memory_limit_bytes"] = options.memory_limit_bytes;
    for (const RayKind kind : options.rays) {
        json["kinds"].push_back(name_of(kind));
    }
    return json;
}

}  // namespace

Json tune_document(const TuneOptions& options, std::span<const TuneResult> results) {
    Json json;
    json["machine"] = provenance_json();
    json["options"] = options_json(options);
    json["scenes"] = Json::array();
    for (const TuneResult& result : results) {
        json["scenes"].push_back(result_json(options, result));
    }
    return as_written(json);
}

}  // namespace coppice::lab
