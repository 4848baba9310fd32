#pragma once

#include "coppice/builders/build_report.h"
#include "coppice/export.h"

#include <nlohmann/json_fwd.hpp>

namespace coppice::inline v0 {

/// Serializes all fields under their own names.
COPPICE_EXPORT void to_json(nlohmann::json& json, const BuildEstimate& estimate);

/// Serializes all fields under their own names. `stages` gets a `total`, `notes` is an array of
/// {"option", "reason"}, and a missing estimate is null.
COPPICE_EXPORT void to_json(nlohmann::json& json, const BuildReport& report);

}  // namespace coppice::inline v0
