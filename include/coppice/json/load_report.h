#pragma once

#include "coppice/io/load_mesh.h"

#include <nlohmann/json_fwd.hpp>

namespace coppice::inline v0 {

/// Serializes an issue as {"count": n, "first": [...]}.
void to_json(nlohmann::json& json, const LoadIssue& issue);

/// Serializes a report, all fields under their own names.
void to_json(nlohmann::json& json, const LoadReport& report);

}  // namespace coppice::inline v0
