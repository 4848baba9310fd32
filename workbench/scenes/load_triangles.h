#pragma once

#include "coppice/geom/triangle_mesh.h"
#include "coppice/io/load_mesh.h"
#include "coppice/io/mesh_attributes.h"

#include <filesystem>

namespace coppice::lab {

/// Loads a mesh that rays are to be traced through. Throws Error(unsupported) for one without
/// triangles, and like load_mesh().
[[nodiscard]] TriangleMesh load_triangles(const std::filesystem::path& file,
                                          LoadReport* report = nullptr,
                                          MeshAttributes* attributes = nullptr);

}  // namespace coppice::lab
