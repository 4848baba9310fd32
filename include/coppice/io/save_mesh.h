#pragma once

#include "coppice/export.h"
#include "coppice/geom/triangle_mesh.h"

#include <filesystem>

namespace coppice::inline v0 {

/// Writes a mesh to `file`, in the format that the extension names: .obj (text, with the fewest
/// digits that read back as the same floats) or .ply (binary, little-endian). Writes to a temporary
/// name beside `file` and renames it, so that `file` is never half-written. Throws Error: io if the
/// file cannot be written; unsupported for another extension, a mesh without vertices, or one
/// without triangles as .obj; invalid_argument for a vertex that is not finite or an index out of
/// range.
COPPICE_EXPORT void save_mesh(TriangleMeshView mesh, const std::filesystem::path& file);

}  // namespace coppice::inline v0
