#pragma once

#include "coppice/cost/sah_cost_model.h"
#include "coppice/export.h"

#include <nlohmann/json_fwd.hpp>

namespace coppice::inline v0 {

/// Serializes all constants under their own names. A custom model adds `custom`: true.
COPPICE_EXPORT void to_json(nlohmann::json& json, const SahCostModel& model);

}  // namespace coppice::inline v0
