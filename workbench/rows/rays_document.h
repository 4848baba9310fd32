#pragma once

#include "rows/results.h"

#include <nlohmann/json_fwd.hpp>

namespace coppice::lab {

/// What rays found out about the trees of one scene: `camera`, `light`, `size`, `ray_counts`,
/// `reference`, `correlations`, `calibrations`, `trees` with their times, and of these `fastest` by
/// number of rays and `break_even` of every pair that has one. Null if no rays were traced.
[[nodiscard]] nlohmann::ordered_json rays_document(const SceneResult& scene);

}  // namespace coppice::lab
