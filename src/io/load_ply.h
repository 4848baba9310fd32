#pragma once

#include "coppice/io/mesh_attributes.h"

#include "io/loaded_mesh.h"

#include <filesystem>

namespace coppice::inline v0 {

/// Reads a PLY file, ASCII or binary of either byte order, plain or gzipped. Reads the elements
/// `vertex`, `face` and `tristrips`, with properties in any order and of any type. Other elements
/// are skipped and counted. A file without faces and strips is a point cloud: a mesh without
/// triangles.
[[nodiscard]] LoadedMesh load_ply(const std::filesystem::path& file,
                                  MeshAttributes* attributes = nullptr);

}  // namespace coppice::inline v0
