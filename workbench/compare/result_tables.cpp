#include "compare/result_tables.h"

#include "scenes/ray_sets.h"
#include "text/numbers.h"

#include <fmt/format.h>

#include <set>

namespace coppice::lab {

namespace {

using nlohmann::json;

}  // namespace

std::vector<Measure> bench_measures() {
    return {{"build_seconds", Nature::seconds},        {"bytes_per_triangle", Nature::cost},
            {"peak_bytes_per_triangle", Nature::cost}, {"sah_cost", Nature::cost},
            {"primary_mrays", Nature::speed},          {"shadow_mrays", Nature::speed},
            {"diffuse_mrays", Nature::speed},          {"mismatches", Nature::count}};
}

std::vector<Measure> experiment_measures(bool with_rays) {
    std::vector<Measure> measures{{"sah_cost", Nature::cost}, {"total_seconds", Nature::seconds}};
    if (!with_rays) return measures;
    for (const RayKindEntry& rays : ray_kind_registry()) {
        const std::string kind(rays.name);
        measures.push_back({kind + "_mrays", Nature::speed});
        for (const char* steps : {"_nodes", "_leaves", "_primitives"}) {
            measures.push_back({kind + steps, Nature::cost});
        }
    }
    measures.push_back({"mismatches", Nature::count});
    return measures;
}

bool is_experiment(const json& document) {
    return document.is_object() && document.contains("scenes") && document["scenes"].is_array();
}

bool is_bench(const json& document) {
    return document.is_object() && document.contains("rows") && document["rows"].is_array();
}

ResultTable experiment_table(const json& document, bool names_samplers) {
    ResultTable table;
    for (const json& scene : document["scenes"]) {
        for (const json& row : scene.at("rows")) {
            std::string name = fmt::format("{}, {}, {}", row.at("scene").get<std::string>(),
                                           row.at("primitives").get<std::string>(),
                                           row.at("protocol").get<std::string>());
            if (names_samplers) name += ", " + row.at("sampler").get<std::string>();
            name += fmt::format(", {} %", row.at("sample_percent").get<double>());
            table.add(name, row.at("seed").get<std::uint64_t>(), row);
        }
    }
    return table;
}

ResultTable bench_table(const json& document) {
    ResultTable table;
    for (const json& row : document["rows"]) {
        table.add(fmt::format("{}, {}, {}", row.at("scene").get<std::string>(),
                              row.at("method").get<std::string>(),
                              count_text(row.at("threads").get<std::uint64_t>(), "thread")),
                  0, row);
    }
    return table;
}

bool has_several_samplers(const json& document) {
    std::set<std::string> samplers;
    for (const json& scene : document["scenes"]) {
        for (const json& row : scene.at("rows")) {
            samplers.insert(row.at("sampler").get<std::string>());
        }
    }
    return samplers.size() > 1;
}

}  // namespace coppice::lab
