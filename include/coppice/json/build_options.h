#pragma once

#include "coppice/builders/build_options.h"
#include "coppice/export.h"

#include <nlohmann/json_fwd.hpp>

namespace coppice::inline v0 {

/// Serializes all options under their own names. A custom sampler becomes "custom".
COPPICE_EXPORT void to_json(nlohmann::json& json, const SampleOptions& options);

/// Serializes all options under their own names. A custom split rule becomes "custom".
COPPICE_EXPORT void to_json(nlohmann::json& json, const KdOptions& options);

/// Serializes all options under their own names.
COPPICE_EXPORT void to_json(nlohmann::json& json, const Bvh8Options& options);

/// Serializes the options of the active kind.
COPPICE_EXPORT void to_json(nlohmann::json& json, const BuildOptions& options);

}  // namespace coppice::inline v0
