#pragma once

#include "coppice/builders/build_report.h"

#include <string>

namespace coppice::lab {

/// What `coppice build` prints: the stages with their times and what came out of them, the tree and
/// its cost, its memory, and the estimates beside what was found. `tree` is the word for it.
[[nodiscard]] std::string build_text(const std::string& scene, const std::string& tree,
                                     const BuildReport& report);

/// The scene's and the build's bytes together, and what the process held at most, as a line.
[[nodiscard]] std::string process_text(std::uint64_t scene_bytes, std::uint64_t build_bytes,
                                       std::uint64_t process_bytes);

}  // namespace coppice::lab
