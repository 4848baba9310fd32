// Two results side by side. Trees of one seed are the same for every run, and so are their costs:
// what scatters is the seed, hence pairs. Times scatter within a run and drift between runs, which
// no interval from one run knows: they have a tolerance beside it.

#include "compare/compare.h"

#include "coppice/base/error.h"

#include "scenes/ray_sets.h"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <limits>
#include <map>
#include <set>

namespace coppice::lab {

namespace {

using nlohmann::json;

constexpr double least_seconds = 0.002;

enum class Nature { cost, seconds, speed, count };

struct Measure {
    std::string key;
    Nature nature;
};

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

/// The trees of one row, by seed; a benchmark's have seed 0.
using TreesBySeed = std::map<std::uint64_t, json>;

/// A result's rows under their names, in its order.
struct Table {
    std::vector<std::string> names;
    std::map<std::string, TreesBySeed> rows;

    void add(const std::string& name, std::uint64_t seed, const json& row) {
        if (!rows.contains(name)) names.push_back(name);
        rows[name][seed] = row;
    }
};

bool is_experiment(const json& document) {
    return document.is_object() && document.contains("scenes") && document["scenes"].is_array();
}

bool is_bench(const json& document) {
    return document.is_object() && document.contains("rows") && document["rows"].is_array();
}

Table experiment_table(const json& document, bool names_samplers) {
    Table table;
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

Table bench_table(const json& document) {
    Table table;
    for (const json& row : document["rows"]) {
        const int threads = row.at("threads").get<int>();
        table.add(
            fmt::format("{}, {}, {} thread{}", row.at("scene").get<std::string>(),
                        row.at("method").get<std::string>(), threads, threads == 1 ? "" : "s"),
            0, row);
    }
    return table;
}

std::set<std::string> samplers_of(const json& document) {
    std::set<std::string> samplers;
    for (const json& scene : document["scenes"]) {
        for (const json& row : scene.at("rows")) {
            samplers.insert(row.at("sampler").get<std::string>());
        }
    }
    return samplers;
}

/// The figures of a measure that two rows have for the same seeds.
struct Pairs {
    std::vector<double> before;
    std::vector<double> after;
    std::vector<double> ratios;
};

double ratio_of(double before, double after) {
    if (before == after) return 1.0;
    return before > 0.0 ? after / before : std::numeric_limits<double>::infinity();
}

Pairs pairs_of(const TreesBySeed& before, const TreesBySeed& after, const std::string& key) {
    Pairs pairs;
    for (const auto& [seed, row] : before) {
        const auto other = after.find(seed);
        if (other == after.end() || !row.contains(key) || !other->second.contains(key)) continue;
        const json& a = row[key];
        const json& b = other->second[key];
        if (!a.is_number() || !b.is_number()) continue;  // null: not measured, or not finite
        pairs.before.push_back(a.get<double>());
        pairs.after.push_back(b.get<double>());
        pairs.ratios.push_back(ratio_of(a.get<double>(), b.get<double>()));
    }
    return pairs;
}

double mean_of(const std::vector<double>& values) {
    double sum = 0.0;
    for (const double value : values) {
        sum += value;
    }
    return sum / static_cast<double>(values.size());
}

bool is_beyond_noise(const Difference& found, Nature nature, const CompareOptions& options) {
    if (nature == Nature::count) return found.before != found.after;
    const bool is_time = nature == Nature::seconds;
    if (is_time && std::abs(found.after - found.before) < least_seconds) return false;
    const bool is_cost = nature == Nature::cost;
    // Ratios of a time and of its inverse are to be judged alike.
    const double distance = found.ratio >= 1.0 ? found.ratio - 1.0 : 1.0 / found.ratio - 1.0;
    if (!found.interval) {
        return distance > (is_cost ? options.tolerance : options.time_tolerance);
    }
    const bool is_sure = found.interval->low > 1.0 || found.interval->high < 1.0;
    return is_sure && (is_cost || distance > options.time_tolerance);
}

void compare_row(const std::string& name, const TreesBySeed& before, const TreesBySeed& after,
                 std::span<const Measure> measures, const CompareOptions& options,
                 Comparison& comparison) {
    for (const Measure& measure : measures) {
        const Pairs pairs = pairs_of(before, after, measure.key);
        if (pairs.ratios.empty()) continue;
        ++comparison.figure_count;
        Difference found{.row = name,
                         .measure = measure.key,
                         .before = mean_of(pairs.before),
                         .after = mean_of(pairs.after),
                         .ratio = mean_of(pairs.ratios),
                         .interval = mean_interval(pairs.ratios)};
        found.is_worse =
            measure.nature == Nature::speed ? found.ratio < 1.0 : found.after > found.before;
        if (is_beyond_noise(found, measure.nature, options)) {
            comparison.differences.push_back(std::move(found));
        }
    }
}

/// What of the two documents' circumstances differs.
std::vector<std::string> find_notes(const json& before, const json& after) {
    std::vector<std::string> notes;
    const auto value = [](const json& document, const char* group, const char* key) {
        return document.contains(group) && document[group].contains(key) ? document[group][key]
                                                                         : json();
    };
    for (const char* key : {"cpu", "cores"}) {
        const json a = value(before, "machine", key);
        const json b = value(after, "machine", key);
        if (a != b) {
            notes.push_back(
                fmt::format("machines differ in {} ({}, {}): seconds cannot be compared", key,
                            a.dump(), b.dump()));
        }
    }
    json options = before.value("options", json::object());
    options.update(after.value("options", json::object()));  // the keys of both
    for (const auto& [key, ignored] : options.items()) {
        const bool is_place = key == "out" || key == "scenes" || key == "views";
        const json a = value(before, "options", key.c_str());
        const json b = value(after, "options", key.c_str());
        if (is_place || a == b) continue;
        notes.push_back(fmt::format("options differ in {} ({}, {})", key, a.dump(), b.dump()));
    }
    return notes;
}

/// What the rays of each scene were made from; nothing of scenes that have none.
std::map<std::string, json> ray_origins(const json& document) {
    std::map<std::string, json> origins;
    for (const json& scene : document["scenes"]) {
        const json rays = scene.value("rays", json());
        if (!rays.is_object()) continue;
        origins[scene.value("scene", "")] = {rays.value("camera", json()),
                                             rays.value("light", json()),
                                             rays.value("ray_counts", json())};
    }
    return origins;
}

/// The scenes of both that have other rays in one than in the other.
std::vector<std::string> scenes_of_other_rays(const json& before, const json& after) {
    std::vector<std::string> scenes;
    const std::map<std::string, json> others = ray_origins(after);
    for (const auto& [scene, origin] : ray_origins(before)) {
        const auto other = others.find(scene);
        if (other != others.end() && other->second != origin) scenes.push_back(scene);
    }
    return scenes;
}

std::string names_kind(const json& document) {
    return is_experiment(document) ? "an experiment" : "a benchmark";
}

Comparison compare_tables(const Table& before, const Table& after,
                          std::span<const Measure> measures, const CompareOptions& options) {
    Comparison comparison;
    for (const std::string& name : before.names) {
        const auto other = after.rows.find(name);
        if (other == after.rows.end()) {
            comparison.only_before.push_back(name);
            continue;
        }
        ++comparison.row_count;
        compare_row(name, before.rows.at(name), other->second, measures, options, comparison);
    }
    std::copy_if(after.names.begin(), after.names.end(), std::back_inserter(comparison.only_after),
                 [&](const std::string& name) { return !before.rows.contains(name); });
    return comparison;
}

Comparison compare_documents(const json& before, const json& after, const CompareOptions& options) {
    if (is_bench(before)) {
        return compare_tables(bench_table(before), bench_table(after), bench_measures(), options);
    }
    const bool names_samplers = samplers_of(before).size() > 1 || samplers_of(after).size() > 1;
    const std::vector<std::string> others = scenes_of_other_rays(before, after);
    Comparison comparison = compare_tables(experiment_table(before, names_samplers),
                                           experiment_table(after, names_samplers),
                                           experiment_measures(others.empty()), options);
    if (!others.empty()) {
        comparison.notes.push_back(
            fmt::format("the rays of {} come from elsewhere or are others in number: what rays "
                        "took is not compared",
                        fmt::join(others, ", ")));
    }
    return comparison;
}

}  // namespace

std::size_t Comparison::worse_count() const {
    return static_cast<std::size_t>(std::count_if(differences.begin(), differences.end(),
                                                  [](const Difference& d) { return d.is_worse; }));
}

json load_results(const std::filesystem::path& path) {
    std::error_code ignored;
    const bool is_folder = std::filesystem::is_directory(path, ignored);
    const std::filesystem::path file = is_folder ? path / "results.json" : path;
    std::ifstream stream(file, std::ios::binary);
    if (!stream) throw file_error(ErrorCode::io, file.string(), "cannot open the file");
    json document = json::parse(stream, nullptr, false);
    if (document.is_discarded()) {
        throw file_error(ErrorCode::parse, file.string(), "is not JSON, or not all of it");
    }
    if (!is_experiment(document) && !is_bench(document)) {
        throw file_error(ErrorCode::parse, file.string(),
                         "is not what coppice experiment or coppice bench writes");
    }
    return document;
}

Comparison compare_results(const json& before, const json& after, const CompareOptions& options) {
    for (const json* document : {&before, &after}) {
        if (is_experiment(*document) || is_bench(*document)) continue;
        throw Error(ErrorCode::parse, "not results of coppice experiment or coppice bench");
    }
    if (is_experiment(before) != is_experiment(after)) {
        throw Error(
            ErrorCode::invalid_argument,
            fmt::format("the first file is of {}, the second of {}: they cannot be compared",
                        names_kind(before), names_kind(after)));
    }
    Comparison comparison;
    try {
        comparison = compare_documents(before, after, options);
    } catch (const json::exception& error) {
        throw Error(ErrorCode::parse,
                    fmt::format("a row lacks what it must have: {}", error.what()));
    }
    if (comparison.row_count == 0) {
        throw Error(ErrorCode::invalid_argument, "the two files have no row in common");
    }
    const std::vector<std::string> notes = find_notes(before, after);
    comparison.notes.insert(comparison.notes.begin(), notes.begin(), notes.end());
    return comparison;
}

}  // namespace coppice::lab
