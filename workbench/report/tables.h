#pragma once

#include "report/series.h"
#include "report/thesis_data.h"

#include <nlohmann/json_fwd.hpp>

#include <string>
#include <string_view>

namespace coppice::report {

// Every function here returns an HTML table whose strings are escaped.

/// All rows of one kind of primitive of a scene, as measured, in groups of columns.
[[nodiscard]] std::string make_rows_table(const nlohmann::json& scene, const Series& series);

/// What the rule recommends for each kind and protocol of a scene, beside the thesis's 50 %.
/// `series` are the scene's own.
[[nodiscard]] std::string make_recommendation_table(const nlohmann::json& scene,
                                                    const std::vector<Series>& series);

/// Cost and build time relative to the 100 % tree, here and in the thesis.
[[nodiscard]] std::string make_thesis_table(const Series& series, const ThesisTables& thesis);

/// The fields of an object, a row for each; nested objects are flattened.
[[nodiscard]] std::string make_fields_table(const nlohmann::json& object, std::string_view caption);

}  // namespace coppice::report
