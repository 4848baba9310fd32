#pragma once

#include "coppice/cost/tree_statistics.h"
#include "coppice/export.h"

#include <nlohmann/json_fwd.hpp>

namespace coppice::inline v0 {

/// Serializes all fields under their own names.
COPPICE_EXPORT void to_json(nlohmann::json& json, const TreeStatistics& statistics);

}  // namespace coppice::inline v0
