#pragma once

#include <nlohmann/json_fwd.hpp>

#include <string>

namespace coppice::report {

/// A chart with its caption as HTML; its Vega-Lite specification, which has a height, is the JSON
/// script with the id `id`. Title and note are HTML.
[[nodiscard]] std::string figure(const std::string& id, const std::string& title,
                                 const std::string& note, const nlohmann::json& chart);

}  // namespace coppice::report
