#pragma once

#include "report/exhibits.h"

#include <nlohmann/json_fwd.hpp>

#include <span>
#include <string>

namespace coppice::report {

/// The experiment's results (the document that `coppice experiment` writes as results.json) as one
/// self-contained HTML page: it loads nothing, from the network or the disk. What the results leave
/// out is left out or marked "–". Every string of theirs is escaped. `exhibits` are of the scenes
/// in the results' order; those that are missing are left out, too. Throws Error(invalid_argument)
/// unless `results` is an object with an array `scenes` of objects.
[[nodiscard]] std::string make_report(const nlohmann::json& results,
                                      std::span<const SceneExhibits> exhibits = {});

}  // namespace coppice::report
