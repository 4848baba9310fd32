#pragma once

#include "coppice/io/mesh_attributes.h"

#include <filesystem>
#include <string>
#include <vector>

namespace coppice::inline v0 {

/// Reads the materials of an MTL file in order: newmtl, Kd, Ks, Ke, Ns and illum. Other statements
/// are ignored. A malformed value keeps its default and adds a line to `warnings`; so do textures,
/// which are not read. Throws Error if the file cannot be read.
[[nodiscard]] std::vector<Material> load_mtl(const std::filesystem::path& file,
                                             std::vector<std::string>& warnings);

}  // namespace coppice::inline v0
