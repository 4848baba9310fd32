#pragma once

#include "coppice/io/mesh_attributes.h"

#include "io/loaded_mesh.h"

#include <filesystem>

namespace coppice::inline v0 {

/// Reads the vertices and faces of an OBJ file, plain or gzipped, through tinyobjloader. A face
/// may come before its vertices.
[[nodiscard]] LoadedMesh load_obj(const std::filesystem::path& file,
                                  MeshAttributes* attributes = nullptr);

}  // namespace coppice::inline v0
