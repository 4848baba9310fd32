#pragma once

#include "coppice/io/mesh_attributes.h"

#include <filesystem>
#include <string>
#include <vector>

namespace coppice::inline v0 {

/// The materials of an MTL file in its order: newmtl, Kd, Ks, Ke, Ns and illum; other statements
/// are passed over. A value that cannot be read keeps its default and adds a line to `warnings`, as
/// do textures, which are not read. Throws Error if the file cannot be read.
[[nodiscard]] std::vector<Material> load_mtl(const std::filesystem::path& file,
                                             std::vector<std::string>& warnings);

}  // namespace coppice::inline v0
