#pragma once

#include "report/series.h"

#include <nlohmann/json_fwd.hpp>

#include <string>

namespace coppice::report {

/// What an experiment finds out beyond the thesis, as HTML: where the cost of sampled trees comes
/// from, level by level and by its causes, and what rays measured, where there is data of that.
[[nodiscard]] std::string make_laboratory(const nlohmann::json& scene, const Series& series);

}  // namespace coppice::report
