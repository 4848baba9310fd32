#pragma once

#include <nlohmann/json.hpp>

#include <cstdint>
#include <map>
#include <string>
#include <vector>

namespace coppice::lab {

/// What a figure is of, which decides how much of a difference is noise.
enum class Nature { cost, seconds, speed, count };

/// A figure of a row, under its key in the JSON.
struct Measure {
    std::string key;
    Nature nature;
};

/// The trees of one row, by seed; a benchmark's have seed 0.
using TreesBySeed = std::map<std::uint64_t, nlohmann::json>;

/// A result's rows under their names, in its order.
struct ResultTable {
    std::vector<std::string> names;
    std::map<std::string, TreesBySeed> rows;

    void add(const std::string& name, std::uint64_t seed, const nlohmann::json& row) {
        if (!rows.contains(name)) names.push_back(name);
        rows[name][seed] = row;
    }
};

/// Whether a document is what an experiment, or a benchmark, writes.
[[nodiscard]] bool is_experiment(const nlohmann::json& document);
[[nodiscard]] bool is_bench(const nlohmann::json& document);

/// The figures of a benchmark's rows, or of an experiment's, that are compared.
[[nodiscard]] std::vector<Measure> bench_measures();
[[nodiscard]] std::vector<Measure> experiment_measures(bool with_rays);

/// The rows of a document. Throw nlohmann::json::exception for one whose rows lack what all have.
[[nodiscard]] ResultTable bench_table(const nlohmann::json& document);
[[nodiscard]] ResultTable experiment_table(const nlohmann::json& document, bool names_samplers);

/// Whether the trees of an experiment are of more than one sampler.
[[nodiscard]] bool has_several_samplers(const nlohmann::json& document);

}  // namespace coppice::lab
