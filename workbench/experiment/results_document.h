#pragma once

#include "experiment/experiment_options.h"
#include "rows/results.h"

#include <nlohmann/json_fwd.hpp>

#include <span>
#include <string>
#include <vector>

namespace coppice::lab {

/// The content of results.json: rows with the CSV's keys and values, every option, the machine,
/// compiler and revision, and per scene its load report, the rows' details and the chosen
/// percentages. `command` is the program's argument list. All strings are valid UTF-8 (what is
/// not is replaced), all numbers are finite.
[[nodiscard]] nlohmann::ordered_json results_document(const ExperimentOptions& options,
                                                      std::span<const SceneResult> scenes,
                                                      const std::vector<std::string>& command);

}  // namespace coppice::lab
