#pragma once

#include "lab/results.h"

#include <string>

namespace coppice::lab {

/// The results of a scene as plain text: one table for each kind of primitive with a block for
/// each protocol, rows averaged over the seeds, then the chosen percentages.
[[nodiscard]] std::string result_table(const SceneResult& scene);

}  // namespace coppice::lab
