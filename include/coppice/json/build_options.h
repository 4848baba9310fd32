#pragma once

#include "coppice/builders/build_options.h"

#include <nlohmann/json_fwd.hpp>

namespace coppice::inline v0 {

/// Serializes all options under their own names.
void to_json(nlohmann::json& json, const BuildOptions& options);

}  // namespace coppice::inline v0
