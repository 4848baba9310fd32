#pragma once

#include "coppice/export.h"
#include "coppice/io/load_mesh.h"

#include <nlohmann/json_fwd.hpp>

namespace coppice::inline v0 {

/// Serializes an issue as {"count": n, "first": [...]}.
COPPICE_EXPORT void to_json(nlohmann::json& json, const LoadIssue& issue);

/// Serializes a report, all fields under their own names.
COPPICE_EXPORT void to_json(nlohmann::json& json, const LoadReport& report);

}  // namespace coppice::inline v0
