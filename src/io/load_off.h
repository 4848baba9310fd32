#pragma once

#include "io/loaded_mesh.h"

#include <filesystem>

namespace coppice::inline v0 {

/// Reads an OFF file as text: OFF, and its variants with normals, colours or texture coordinates
/// (NOFF, COFF, STOFF ...), which are ignored. Each vertex and face is a line.
[[nodiscard]] LoadedMesh load_off(const std::filesystem::path& file);

}  // namespace coppice::inline v0
