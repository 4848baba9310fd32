// One table of columns makes both the CSV and the JSON rows, so that they cannot differ.

#include "rows/results.h"

#include "text/json_text.h"

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

/// What was not measured.
struct Nothing {};

using Cell = std::variant<Nothing, std::string, std::uint64_t, double, Seconds>;

struct Column {
    std::string_view name;
    Cell (*cell)(const ResultRow&);
};

/// A column of one kind of rays.
struct RayColumn {
    std::string_view name;  ///< behind that of the kind
    Cell (*cell)(const RayFigures&);
};

Cell count(std::uint64_t value) {
    return value;
}

/// A count of what a peer's tree does not tell.
Cell tree_count(const ResultRow& row, std::uint64_t value) {
    return row.form == TreeForm::peer ? Cell(Nothing{}) : Cell(value);
}

Cell total_mismatches(const ResultRow& row) {
    if (row.rays.empty()) return Nothing{};
    std::uint64_t sum = 0;
    for (const RayFigures& figures : row.rays) {
        sum += figures.mismatches;
    }
    return sum;
}

Cell mean_nanoseconds(const ResultRow& row) {
    const std::optional<double> mean = nanoseconds_of(row.rays);
    return mean ? Cell(*mean) : Cell(Nothing{});
}

constexpr std::array columns{
    Column{"scene", [](const ResultRow& r) { return Cell(r.scene); }},
    Column{"primitives", [](const ResultRow& r) { return Cell(r.primitives); }},
    Column{"protocol", [](const ResultRow& r) { return Cell(r.protocol); }},
    Column{"split",
           [](const ResultRow& r) {
               return Cell(r.form == TreeForm::kd ? std::get<KdOptions>(r.report.options).split.rule
                                                  : std::string());
           }},
    Column{"sampler", [](const ResultRow& r) { return Cell(r.sampler); }},
    Column{"sample_percent", [](const ResultRow& r) { return Cell(r.sample_percent); }},
    Column{"seed", [](const ResultRow& r) { return Cell(r.seed); }},
    Column{"primitive_count", [](const ResultRow& r) { return count(r.report.primitive_count); }},
    Column{"sample_count", [](const ResultRow& r) { return count(r.report.sample_count); }},
    Column{"node_count",
           [](const ResultRow& r) { return tree_count(r, r.report.statistics.node_count); }},
    Column{"inner_count",
           [](const ResultRow& r) { return tree_count(r, r.report.statistics.inner_count); }},
    Column{"leaf_count",
           [](const ResultRow& r) { return tree_count(r, r.report.statistics.leaf_count); }},
    Column{"single_primitive_leaf_count",
           [](const ResultRow& r) {
               return tree_count(r, r.report.statistics.single_primitive_leaf_count);
           }},
    Column{"empty_leaf_count",
           [](const ResultRow& r) { return tree_count(r, r.report.statistics.empty_leaf_count); }},
    Column{"reference_count",
           [](const ResultRow& r) { return tree_count(r, r.report.statistics.reference_count); }},
    Column{"max_level",
           [](const ResultRow& r) {
               return tree_count(r, static_cast<std::uint64_t>(r.report.statistics.max_level));
           }},
    Column{"mean_leaf_size",
           [](const ResultRow& r) {
               return r.form == TreeForm::peer ? Cell(Nothing{})
                                               : Cell(r.report.statistics.mean_leaf_size);
           }},
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

/// Behind the others if rays were asked for, and before the columns of each kind.
constexpr std::array all_rays_columns{
    Column{"ray_nanoseconds", mean_nanoseconds},
    Column{"mismatches", total_mismatches},
};

Cell steps(const RayFigures& figures, double MeanSteps::*member) {
    return figures.steps ? Cell((*figures.steps).*member) : Cell(Nothing{});
}

constexpr std::array ray_columns{
    RayColumn{"_mrays", [](const RayFigures& f) { return Cell(f.mrays()); }},
    RayColumn{"_nodes", [](const RayFigures& f) { return steps(f, &MeanSteps::nodes); }},
    RayColumn{"_leaves", [](const RayFigures& f) { return steps(f, &MeanSteps::leaves); }},
    RayColumn{"_primitives", [](const RayFigures& f) { return steps(f, &MeanSteps::primitives); }},
};

Cell ray_cell(const ResultRow& row, RayKind kind, const RayColumn& column) {
    for (const RayFigures& figures : row.rays) {
        if (figures.kind == kind) return column.cell(figures);
    }
    return Nothing{};
}

/// Calls `visit(name, cell of a row)` for every column, in order.
template <typename Visit>
void for_each_column(std::span<const RayKind> rays, Visit&& visit) {
    for (const Column& column : columns) {
        visit(std::string(column.name), column.cell);
    }
    if (rays.empty()) return;
    for (const Column& column : all_rays_columns) {
        visit(std::string(column.name), column.cell);
    }
    for (const RayKind kind : rays) {
        for (const RayColumn& column : ray_columns) {
            visit(std::string(name_of(kind)) + std::string(column.name),
                  [kind, &column](const ResultRow& row) { return ray_cell(row, kind, column); });
        }
    }
}

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
    std::string operator()(Nothing /*nothing*/) const { return {}; }

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
    nlohmann::ordered_json operator()(Nothing /*nothing*/) const { return nullptr; }

    nlohmann::ordered_json operator()(const std::string& text) const { return text; }

    nlohmann::ordered_json operator()(std::uint64_t value) const { return value; }

    nlohmann::ordered_json operator()(double value) const { return number_json(value); }

    nlohmann::ordered_json operator()(Seconds seconds) const { return (*this)(seconds.value); }
};

}  // namespace

std::string csv_header(std::span<const RayKind> rays) {
    std::string header;
    for_each_column(rays, [&](const std::string& name, const auto& /*cell*/) {
        if (!header.empty()) header += ',';
        header += name;
    });
    return header;
}

std::string csv_text(std::span<const SceneResult> scenes, std::span<const RayKind> rays) {
    std::string text = csv_header(rays) + '\n';
    for (const SceneResult& scene : scenes) {
        for (const ResultRow& row : scene.rows) {
            for_each_column(rays, [&](const std::string& /*name*/, const auto& cell) {
                text += std::visit(CsvField{}, Cell(cell(row))) + ',';
            });
            text.back() = '\n';
        }
    }
    return text;
}

nlohmann::ordered_json row_json(const ResultRow& row, std::span<const RayKind> rays) {
    nlohmann::ordered_json json;
    for_each_column(rays, [&](const std::string& name, const auto& cell) {
        json[name] = std::visit(JsonValue{}, Cell(cell(row)));
    });
    return json;
}

}  // namespace coppice::lab
