// Compares two results row by row. Trees of one seed, and their costs, are the same in every run;
// only the choice of seed scatters, so figures are paired by seed. Times scatter within a run and
// drift between runs. An interval from one run does not cover the drift, so times must also differ
// by more than a tolerance.

#include "compare/compare.h"

#include "coppice/base/error.h"

#include "compare/circumstances.h"
#include "compare/result_tables.h"
#include "statistics/mean.h"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <limits>

namespace coppice::lab {

namespace {

using nlohmann::json;

constexpr double least_seconds = 0.002;

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

std::string names_kind(const json& document) {
    return is_experiment(document) ? "an experiment" : "a benchmark";
}

Comparison compare_tables(const ResultTable& before, const ResultTable& after,
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
    const bool names_samplers = has_several_samplers(before) || has_several_samplers(after);
    const std::vector<std::string> others = scenes_of_other_rays(before, after);
    Comparison comparison = compare_tables(experiment_table(before, names_samplers),
                                           experiment_table(after, names_samplers),
                                           experiment_measures(others.empty()), options);
    if (!others.empty()) {
        comparison.notes.push_back(
            fmt::format("the rays of {} differ in camera, light or number, so ray figures are not "
                        "compared",
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
        throw file_error(
            ErrorCode::parse, file.string(),
            "is not JSON, or is cut off; give the results.json of an experiment, or the "
            "file of coppice bench --json");
    }
    if (!is_experiment(document) && !is_bench(document)) {
        throw file_error(ErrorCode::parse, file.string(),
                         "is JSON, but not a result of coppice experiment or coppice bench");
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
            fmt::format("the first file is the result of {}, the second of {}; compare two of the "
                        "same kind",
                        names_kind(before), names_kind(after)));
    }
    Comparison comparison;
    try {
        comparison = compare_documents(before, after, options);
    } catch (const json::exception& error) {
        throw Error(ErrorCode::parse,
                    fmt::format("a row of the results is incomplete: {}", error.what()));
    }
    if (comparison.row_count == 0) {
        throw Error(ErrorCode::invalid_argument,
                    "the two results have no row in common: compare results of the same scenes "
                    "and methods");
    }
    const std::vector<std::string> notes = find_notes(before, after);
    comparison.notes.insert(comparison.notes.begin(), notes.begin(), notes.end());
    return comparison;
}

}  // namespace coppice::lab
