// One table of columns makes both the CSV and the JSON rows, so that they cannot differ.

#include "lab/results.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <array>
#include <cmath>
#include <variant>

namespace coppice::lab {

namespace {

/// A wall-clock time, rounded to the microsecond once for both files: k / 1e6 is the double next to
/// the decimal number k * 1e-6, so that six decimals and the shortest digits read back the same.
struct Seconds {
    explicit Seconds(double seconds) : value(std::nearbyint(seconds * 1e6) / 1e6) {}

    double value;
};

using Cell = std::variant<std::string, std::uint64_t, double, Seconds>;

struct Column {
    std::string_view name;
    Cell (*cell)(const ResultRow&);
};

Cell count(std::uint64_t value) {
    return value;
}

constexpr std::array columns{
    Column{"scene", [](const ResultRow& r) { return Cell(r.scene); }},
    Column{"primitives", [](const ResultRow& r) { return Cell(r.primitives); }},
    Column{"protocol", [](const ResultRow& r) { return Cell(r.protocol); }},
    Column{"split", [](const ResultRow& r) { return Cell(r.report.options.split.rule); }},
    Column{"sampler", [](const ResultRow& r) { return Cell(r.report.options.sample.sampler); }},
    Column{"sample_percent", [](const ResultRow& r) { return Cell(r.sample_percent); }},
    Column{"seed", [](const ResultRow& r) { return Cell(r.seed); }},
    Column{"primitive_count", [](const ResultRow& r) { return count(r.report.primitive_count); }},
    Column{"sample_count", [](const ResultRow& r) { return count(r.report.sample_count); }},
    Column{"node_count", [](const ResultRow& r) { return count(r.report.statistics.node_count); }},
    Column{"inner_count",
           [](const ResultRow& r) { return count(r.report.statistics.inner_count); }},
    Column{"leaf_count", [](const ResultRow& r) { return count(r.report.statistics.leaf_count); }},
    Column{
        "single_primitive_leaf_count",
        [](const ResultRow& r) { return count(r.report.statistics.single_primitive_leaf_count); }},
    Column{"empty_leaf_count",
           [](const ResultRow& r) { return count(r.report.statistics.empty_leaf_count); }},
    Column{"reference_count",
           [](const ResultRow& r) { return count(r.report.statistics.reference_count); }},
    Column{"max_level",
           [](const ResultRow& r) {
               return count(static_cast<std::uint64_t>(r.report.statistics.max_level));
           }},
    Column{"mean_leaf_size",
           [](const ResultRow& r) { return Cell(r.report.statistics.mean_leaf_size); }},
    Column{"sample_seconds",
           [](const ResultRow& r) { return Cell(Seconds{r.report.stages.sample.wall_seconds}); }},
    Column{"build_seconds",
           [](const ResultRow& r) { return Cell(Seconds{r.report.stages.build.wall_seconds}); }},
    Column{"empty_seconds",
           [](const ResultRow& r) { return Cell(Seconds{r.report.stages.empty.wall_seconds}); }},
    Column{"refill_seconds",
           [](const ResultRow& r) { return Cell(Seconds{r.report.stages.refill.wall_seconds}); }},
    Column{"refine_seconds",
           [](const ResultRow& r) { return Cell(Seconds{r.report.stages.refine.wall_seconds}); }},
    Column{"total_seconds",
           [](const ResultRow& r) { return Cell(Seconds{r.report.stages.wall_seconds()}); }},
    Column{"sah_cost", [](const ResultRow& r) { return Cell(r.report.statistics.sah_cost); }},
    Column{"relative_cost", [](const ResultRow& r) { return Cell(r.relative_cost); }},
};

std::string quoted(const std::string& text) {
    if (text.find_first_of(",\"\r\n") == std::string::npos) return text;
    std::string quoted = "\"";
    for (const char c : text) {
        if (c == '"') quoted += '"';
        quoted += c;
    }
    return quoted + '"';
}

struct CsvField {
    std::string operator()(const std::string& text) const { return quoted(text); }

    std::string operator()(std::uint64_t value) const { return fmt::format("{}", value); }

    std::string operator()(double value) const {
        return std::isfinite(value) ? fmt::format("{}", value) : std::string();
    }

    std::string operator()(Seconds seconds) const {
        return std::isfinite(seconds.value) ? fmt::format("{:.6f}", seconds.value) : std::string();
    }
};

struct JsonValue {
    nlohmann::ordered_json operator()(const std::string& text) const { return text; }

    nlohmann::ordered_json operator()(std::uint64_t value) const { return value; }

    nlohmann::ordered_json operator()(double value) const {
        return std::isfinite(value) ? nlohmann::ordered_json(value) : nlohmann::ordered_json();
    }

    nlohmann::ordered_json operator()(Seconds seconds) const { return (*this)(seconds.value); }
};

}  // namespace

std::string csv_header() {
    std::string header;
    for (const Column& column : columns) {
        if (!header.empty()) header += ',';
        header += column.name;
    }
    return header;
}

std::string csv_text(std::span<const SceneResult> scenes) {
    std::string text = csv_header() + '\n';
    for (const SceneResult& scene : scenes) {
        for (const ResultRow& row : scene.rows) {
            for (const Column& column : columns) {
                text += std::visit(CsvField{}, column.cell(row));
                text += &column == &columns.back() ? '\n' : ',';
            }
        }
    }
    return text;
}

nlohmann::ordered_json row_json(const ResultRow& row) {
    nlohmann::ordered_json json;
    for (const Column& column : columns) {
        json[std::string(column.name)] = std::visit(JsonValue{}, column.cell(row));
    }
    return json;
}

}  // namespace coppice::lab
