#pragma once

#include "report/exhibits.h"

#include <string>
#include <string_view>

namespace coppice::report {

// Every function here returns HTML whose strings are escaped, or "" where there is nothing to show.

/// The picture of a scene, embedded.
[[nodiscard]] std::string make_picture(const SceneExhibits& exhibits, std::string_view scene);

/// The heat maps of two trees and their difference, embedded, with their scales and means.
[[nodiscard]] std::string make_heat_maps(const SceneExhibits& exhibits, std::string_view scene);

/// The place and the data of the tree inspector, which the page's script draws. `key` is fit for
/// ids and unique on the page.
[[nodiscard]] std::string make_inspector(const SceneExhibits& exhibits, std::string_view key);

}  // namespace coppice::report
