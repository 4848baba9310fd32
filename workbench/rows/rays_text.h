#pragma once

#include "rows/results.h"

#include <string>

namespace coppice::lab {

/// What rays found out about the trees of one scene, as plain text: steps and speeds of each, how
/// well the cost predicts them, the constants of this machine, and which tree has an image first.
/// Empty if no rays were traced.
[[nodiscard]] std::string rays_text(const SceneResult& scene);

}  // namespace coppice::lab
