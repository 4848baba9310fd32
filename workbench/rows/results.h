#pragma once

#include "coppice/builders/build_report.h"
#include "coppice/geom/aabb.h"
#include "coppice/io/load_mesh.h"

#include "rows/ray_figures.h"
#include "rows/tree_form.h"
#include "rows/tree_key.h"
#include "scenes/ray_maker.h"
#include "statistics/confidence.h"
#include "statistics/knee.h"

#include <nlohmann/json_fwd.hpp>

#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace coppice::lab {

/// All that is measured of one tree.
struct TreeFigures {
    BuildReport report;
    /// Primitives a random line through the box is tested against in leaves that were empty in the
    /// sample; of trees that do not grow.
    double unsampled_tests = 0.0;
    std::vector<RayFigures> rays;  ///< of triangles only, in the order asked for; or none
};

/// One tree of the experiment: what was built, and what it measured.
struct ResultRow : TreeKey {
    BuildReport report;
    double relative_cost = 1.0;  ///< sah_cost over that of the 100 % tree of the same scene,
                                 ///< series and seed; NaN if that is 0 and this not
    double relative_time = 1.0;  ///< the same for the total time; not a column
    TreeForm form = TreeForm::kd;
    double unsampled_tests = 0.0;  ///< as in TreeFigures
    std::vector<RayFigures> rays;  ///< likewise
};

/// The percentage chosen for one series of trees.
struct Recommendation : TreeSeries {
    KneePoint chosen;
    std::optional<Interval> relative_time;  ///< of the mean over the seeds; nothing for one seed

    /// Whether building it surely takes less time than the full tree.
    [[nodiscard]] bool saves_time() const {
        return (relative_time ? relative_time->high : chosen.time) < 1.0;
    }
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
    /// By primitives, protocol, sampler, seed, then rate, each as asked for.
    std::vector<ResultRow> rows;
    std::optional<RayOptions> view;  ///< of the rays, if any were asked for and there are triangles
    std::vector<std::string> errors;          ///< what must not be: hits that differ
    std::vector<std::string> failures;        ///< trees that have no row, and why
    std::vector<Recommendation> recommended;  ///< by recommend(), with the options' tolerance
    std::vector<Recommendation> knees;        ///< by find_knees()
};

/// The header line of results.csv, without a line end; with the columns of these kinds of rays.
[[nodiscard]] std::string csv_header(std::span<const RayKind> rays = {});

/// results.csv: the header and one line per row of all scenes, as RFC 4180 quotes, with '\n' line
/// ends. Costs have the shortest digits that read back the same, seconds six decimals; a number
/// that is not finite or was not measured is an empty field.
[[nodiscard]] std::string csv_text(std::span<const SceneResult> scenes,
                                   std::span<const RayKind> rays = {});

/// One row as an object with the CSV's columns as keys and the same values; what is empty there is
/// null; empty texts stay.
[[nodiscard]] nlohmann::ordered_json row_json(const ResultRow& row,
                                              std::span<const RayKind> rays = {});

}  // namespace coppice::lab
