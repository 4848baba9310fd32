#pragma once

#include "coppice/build/build_report.h"

#include <string>

namespace coppice::lab {

/// What `coppice build` prints: the stages with their times and what came out of them, the tree and
/// its cost, its memory, and the estimates beside what was found. `tree` is the word for it.
[[nodiscard]] std::string build_text(const std::string& scene, const std::string& tree,
                                     const BuildReport& report);

}  // namespace coppice::lab
