#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <vector>

namespace coppice::lab {

/// A scene's short name: the file name without ".gz" and without its extension.
/// `scenes/motorBike.obj.gz` is `motorBike`.
[[nodiscard]] std::string scene_name(const std::filesystem::path& file);

/// The short names of several scenes, made unique: of equal ones the second becomes `name-2`, the
/// third `name-3` and so on.
[[nodiscard]] std::vector<std::string> scene_names(std::span<const std::filesystem::path> files);

/// The folder for an experiment's results if none is asked for: `out/<name>`, or
/// `out/<first name>-and-<n>-more` for several scenes.
[[nodiscard]] std::filesystem::path default_output_folder(
    std::span<const std::filesystem::path> files);

}  // namespace coppice::lab
