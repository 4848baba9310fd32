#pragma once

#include "coppice/build/build_report.h"
#include "coppice/geom/aabb.h"
#include "coppice/io/load_mesh.h"

#include "lab/knee.h"

#include <nlohmann/json_fwd.hpp>

#include <compare>
#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace coppice::lab {

/// Which tree of an experiment.
struct RowKey {
    std::string scene;
    std::string primitives;
    std::string protocol;
    double sample_percent = 100.0;
    std::uint64_t seed = 1;

    auto operator<=>(const RowKey&) const = default;
};

/// One tree of the experiment: what was built, and what it measured.
struct ResultRow {
    std::string scene;
    std::string primitives;  ///< "points" or "triangles"
    std::string protocol;
    double sample_percent = 100.0;
    std::uint64_t seed = 1;
    BuildReport report;
    double relative_cost = 1.0;  ///< sah_cost over that of the 100 % tree of the same scene,
                                 ///< primitives, protocol and seed; NaN if that is 0 and this not
    double relative_time = 1.0;  ///< the same for the total time; not a column
};

/// The percentage chosen for one scene, kind of primitive and protocol.
struct Recommendation {
    std::string primitives;
    std::string protocol;
    KneePoint chosen;
};

/// All that was found out about one scene.
struct SceneResult {
    std::string scene;           ///< short and unique within the experiment
    std::filesystem::path file;  ///< as given
    LoadReport load_report;
    std::uint64_t vertex_count = 0;
    std::uint64_t triangle_count = 0;
    std::uint64_t distinct_vertex_count = 0;  ///< 0 if no tree of points was asked for
    Aabb bounds;
    std::vector<ResultRow> rows;  ///< by primitives, protocol, seed, then rate, each as asked for
    std::vector<Recommendation> recommended;  ///< by recommend(), with the options' tolerance
    std::vector<Recommendation> knees;        ///< by find_knees()
};

/// The header line of results.csv, without a line end.
[[nodiscard]] std::string csv_header();

/// results.csv: the header and one line per row of all scenes, as RFC 4180 quotes, with '\n' line
/// ends. Costs have the shortest digits that read back the same, seconds six decimals; a number
/// that is not finite is an empty field.
[[nodiscard]] std::string csv_text(std::span<const SceneResult> scenes);

/// One row as an object with the CSV's columns as keys and the same values; not finite is null.
[[nodiscard]] nlohmann::ordered_json row_json(const ResultRow& row);

}  // namespace coppice::lab
