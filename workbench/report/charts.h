#pragma once

#include "report/series.h"
#include "report/thesis_data.h"

#include <nlohmann/json.hpp>

#include <string>
#include <string_view>

namespace coppice::report {

// Every function here returns a Vega-Lite specification with its data inside. Where there are
// several seeds, marks stand at the mean and bands or rules reach from the least to the greatest.

/// What a chart over the sample percentages shows.
struct Measure {
    std::string key;          ///< in the results' rows or details
    std::string title;        ///< of its axis
    bool is_seconds = false;  ///< drawn in the unit that suits the values
    bool is_share = false;    ///< drawn in percent
};

/// SAH cost against build time of all trees over one kind of primitive, a line for each protocol,
/// points labelled by percentage, recommended ones ringed; axes are logarithmic where needed. Not
/// relative to anything: protocols can be compared.
[[nodiscard]] nlohmann::json make_cost_time_chart(const Series& series);

/// The same from the results document, of the first scene with that name and that kind.
/// Throws Error(invalid_argument) where the results have no such trees.
[[nodiscard]] nlohmann::json make_cost_time_chart(const nlohmann::json& results,
                                                  std::string_view scene, std::string_view kind);

/// The same on linear axes: the diagram of the thesis (figures 9 to 12).
[[nodiscard]] nlohmann::json make_linear_cost_time_chart(const Series& series);

/// One measure over the sample percentages, a line for each protocol.
[[nodiscard]] nlohmann::json make_rate_chart(const Series& series, const Measure& measure);

/// The seconds of the five stages, stacked, for each percentage of one protocol. All protocols of
/// a series share the ends of the axis.
[[nodiscard]] nlohmann::json make_stage_chart(const Series& series, std::string_view protocol);

/// `depth_histogram` or `cost_share_by_depth` level by level, for a percentage the reader chooses,
/// before the full tree's.
[[nodiscard]] nlohmann::json make_level_chart(const Series& series, const Measure& measure);

/// What the thesis published of each tree.
enum class ThesisMeasure { cost, build_time };

/// The measure relative to the 100 % tree, beside the thesis's own.
[[nodiscard]] nlohmann::json make_thesis_chart(const Series& series, const ThesisTables& thesis,
                                               ThesisMeasure measure);

}  // namespace coppice::report
