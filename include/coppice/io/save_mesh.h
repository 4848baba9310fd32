#pragma once

#include "coppice/export.h"
#include "coppice/geom/triangle_mesh.h"

#include <filesystem>

namespace coppice::inline v0 {

/// Writes a mesh as .obj (text, shortest digits that read back the same floats) or .ply (binary
/// little-endian), chosen by the file name. Written to a temporary name beside `file` and renamed,
/// so that no half-written file is ever left under `file`. Throws Error (io, unsupported).
COPPICE_EXPORT void save_mesh(TriangleMeshView mesh, const std::filesystem::path& file);

}  // namespace coppice::inline v0
