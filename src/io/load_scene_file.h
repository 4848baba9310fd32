#pragma once

#include "coppice/io/mesh_attributes.h"

#include "io/loaded_mesh.h"

#include <filesystem>
#include <string>
#include <string_view>

namespace coppice::inline v0 {

/// True if Assimp reads files with this extension, which includes the dot.
[[nodiscard]] bool is_scene_file_extension(const std::string& extension);

/// A supplement for the error message about an unknown extension: the formats that Assimp would
/// read and how to enable them. Empty if the library was built with Assimp.
[[nodiscard]] std::string_view missing_scene_formats() noexcept;

/// Reads all meshes of a file through Assimp, once for each node that refers to them, in world
/// space.
[[nodiscard]] LoadedMesh load_scene_file(const std::filesystem::path& file,
                                         MeshAttributes* attributes = nullptr);

}  // namespace coppice::inline v0
