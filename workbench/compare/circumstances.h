#pragma once

#include <nlohmann/json.hpp>

#include <string>
#include <vector>

namespace coppice::lab {

/// What of the circumstances of two results differs: machine and options, one line each.
[[nodiscard]] std::vector<std::string> find_notes(const nlohmann::json& before,
                                                  const nlohmann::json& after);

/// The scenes that both experiments traced, but with other rays.
[[nodiscard]] std::vector<std::string> scenes_of_other_rays(const nlohmann::json& before,
                                                            const nlohmann::json& after);

}  // namespace coppice::lab
