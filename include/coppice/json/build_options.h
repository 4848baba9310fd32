#pragma once

#include "coppice/builders/build_options.h"
#include "coppice/export.h"

#include <nlohmann/json_fwd.hpp>

namespace coppice::inline v0 {

/// Serializes all options under their own names; a sampler of your own as "custom".
COPPICE_EXPORT void to_json(nlohmann::json& json, const SampleOptions& options);

/// Serializes all options under their own names; a split rule of your own as "custom".
COPPICE_EXPORT void to_json(nlohmann::json& json, const KdOptions& options);

/// Serializes all options under their own names.
COPPICE_EXPORT void to_json(nlohmann::json& json, const Bvh8Options& options);

/// The options of either kind as they are.
COPPICE_EXPORT void to_json(nlohmann::json& json, const BuildOptions& options);

}  // namespace coppice::inline v0
