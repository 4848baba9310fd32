#pragma once

#include "report/series.h"
#include "report/thesis_data.h"

#include <nlohmann/json_fwd.hpp>

#include <string>
#include <vector>

namespace coppice::report {

// Every function here returns HTML sentences, made from the numbers of the results alone.

/// What the rule recommends for a scene, in a sentence: the smallest sample, of triangles if there
/// are trees of them, and what that costs. `series` are the scene's own.
[[nodiscard]] std::string make_answer(const nlohmann::json& scene,
                                      const std::vector<Series>& series);

/// What sampling did to the trees of a series, an item for each protocol.
[[nodiscard]] std::string make_findings(const Series& series);

/// How the series differs from the thesis's published numbers, and why.
[[nodiscard]] std::string make_thesis_comparison(const Series& series, const ThesisTables& thesis);

}  // namespace coppice::report
