#pragma once

#include <nlohmann/json.hpp>

#include <cmath>
#include <string>
#include <vector>

namespace coppice::report::test {

/// What a results document for the tests is made of.
struct Experiment {
    std::vector<std::string> scenes{"dragon"};
    std::vector<std::string> kinds{"points", "triangles"};
    std::vector<std::string> protocols{"fixed", "scaled", "grown"};
    std::vector<double> percents{100, 50, 10, 1};
    std::vector<int> seeds{1};
};

/// The cost over the 100 % tree's: steep, less steep, nearly flat.
inline double relative_cost(const std::string& protocol, double percent) {
    const double reduction = 100.0 / percent;
    if (protocol == "fixed") return std::pow(reduction, 0.8);
    if (protocol == "scaled") return std::pow(reduction, 0.4);
    return 1.0 + 0.005 * std::log2(reduction);
}

inline nlohmann::json make_row(const std::string& scene, const std::string& kind,
                               const std::string& protocol, double percent, int seed) {
    const double count = kind == "points" ? 437'645 : 871'414;
    const double rate = percent / 100.0;
    const int leaves = static_cast<int>(count / 8.0 * (protocol == "grown" ? 1.0 : rate)) + 1;
    // Seeds differ by a tenth of the cost and of the time.
    const double relative = relative_cost(protocol, percent) * (1.0 + 0.1 * (seed - 1));
    const double build = 2.0 * rate * (1.0 + 0.1 * (seed - 1));
    const double refine = protocol == "grown" ? 0.5 : 0.0;
    return {{"scene", scene},
            {"primitives", kind},
            {"protocol", protocol},
            {"split", "sah"},
            {"sampler", "uniform"},
            {"sample_percent", percent},
            {"seed", seed},
            {"primitive_count", count},
            {"sample_count", std::floor(count * rate)},
            {"node_count", 2 * leaves - 1},
            {"inner_count", leaves - 1},
            {"leaf_count", leaves},
            {"single_primitive_leaf_count", leaves / 20},
            {"empty_leaf_count", leaves / 5},
            {"reference_count", count},
            {"max_level", static_cast<int>(24 + std::log2(rate))},
            {"mean_leaf_size", count / leaves},
            {"sample_seconds", 0.001},
            {"build_seconds", build},
            {"empty_seconds", 0.0},
            {"refill_seconds", 0.04},
            {"refine_seconds", refine},
            {"total_seconds", 0.001 + build + 0.04 + refine},
            {"sah_cost", 88.5 * relative},
            {"relative_cost", relative}};
}

inline nlohmann::json make_detail(const std::string& kind, const std::string& protocol,
                                  double percent, int seed) {
    return {{"primitives", kind},
            {"protocol", protocol},
            {"sample_percent", percent},
            {"seed", seed},
            {"expected_inner_visits", percent == 100.0 ? 50.0 : 30.0},
            {"expected_leaf_visits", 11.0},
            {"expected_primitive_tests", 10.0 * relative_cost(protocol, percent)},
            {"depth_histogram", {0, 1, 2, 4 * seed}},
            {"cost_share_by_depth", {0.1, 0.2, 0.3, 0.4}}};
}

/// A results document as the lab writes it; the rule recommends the second percentage.
inline nlohmann::json make_results(const Experiment& experiment = {}) {
    nlohmann::json scenes = nlohmann::json::array();
    for (const std::string& name : experiment.scenes) {
        nlohmann::json scene{{"scene", name},
                             {"file", "scenes/" + name + ".obj"},
                             {"vertex_count", 437'645},
                             {"triangle_count", 871'414},
                             {"bounds", {{"lower", {-1, -2, -3}}, {"upper", {1, 2, 3}}}},
                             {"load_report", {{"format", "obj"}, {"load_seconds", 0.412}}},
                             {"rows", nlohmann::json::array()},
                             {"details", nlohmann::json::array()},
                             {"recommended", nlohmann::json::array()}};
        for (const std::string& kind : experiment.kinds) {
            for (const std::string& protocol : experiment.protocols) {
                for (const int seed : experiment.seeds) {
                    for (const double percent : experiment.percents) {
                        scene["rows"].push_back(make_row(name, kind, protocol, percent, seed));
                        scene["details"].push_back(make_detail(kind, protocol, percent, seed));
                    }
                }
                if (experiment.percents.size() < 2) continue;
                const double chosen = experiment.percents[1];
                scene["recommended"].push_back({{"primitives", kind},
                                                {"protocol", protocol},
                                                {"sample_percent", chosen},
                                                {"relative_cost", relative_cost(protocol, chosen)},
                                                {"relative_time", 0.25},
                                                {"rule", "kneedle"},
                                                {"source", "Satopaa et al. 2011"}});
            }
        }
        scenes.push_back(std::move(scene));
    }
    return {{"coppice", "0.1.0"},
            {"created", "2026-11-22T05:40:00Z"},
            {"git_revision", "abc1234"},
            {"compiler", "GCC 12.2.0 -O3"},
            {"build_type", "Release"},
            {"machine", {{"cpu", "a processor"}, {"cores", 2}, {"memory_bytes", 16'777'216'000}}},
            {"options",
             {{"traversal_cost", 1},
              {"intersection_cost", 1},
              {"empty_bonus", 0.5},
              {"max_depth", 50},
              {"max_leaf", 32},
              {"bad_refines", 3}}},
            {"scenes", scenes}};
}

/// What a user may call a scene.
inline const char* const evil_name = "</script><b onmouseover=\"alert('1')\">&{{title}}<!--";

}  // namespace coppice::report::test
