#pragma once

#include "coppice/export.h"
#include "coppice/geom/triangle_mesh.h"

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace coppice::inline v0 {

struct MeshAttributes;

/// How often an irregular but legal thing occurred in a file, and where it occurred first.
struct COPPICE_EXPORT LoadIssue {
    /// The greatest number of places kept in `first`.
    static constexpr std::size_t kept_places = 8;

    std::uint64_t count = 0;  ///< number of occurrences
    /// The 0-based ids of the first faces, triangles or vertices concerned; at most `kept_places`.
    std::vector<std::uint64_t> first;

    /// Counts one more occurrence, at id `place`.
    void add(std::uint64_t place);
};

/// What a file contained, and its irregularities. Nothing is dropped without being counted here.
struct LoadReport {
    std::string file;                  ///< path of the file as given
    std::string format;                ///< "obj", "ply", "off" or Assimp's name of the format
    std::uint64_t file_bytes = 0;      ///< size on disk
    double load_seconds = 0.0;         ///< wall-clock time to read the file and count its issues
    std::uint64_t vertex_count = 0;    ///< vertices in the mesh
    std::uint64_t face_count = 0;      ///< faces in the file, before polygons become triangles
    std::uint64_t triangle_count = 0;  ///< triangles in the mesh
    LoadIssue polygons;             ///< faces of more than three corners, cut into fans (face ids)
    LoadIssue degenerate_faces;     ///< faces of fewer than three corners, not triangles (face ids)
    LoadIssue zero_area_triangles;  ///< kept: they are primitives that no ray hits (triangle ids)
    LoadIssue duplicate_triangles;  ///< kept: same corner positions as an earlier one, in any order
    LoadIssue
        duplicate_vertices;     ///< kept: same position as an earlier vertex; -0 and +0 are equal
    LoadIssue unused_vertices;  ///< kept: in no triangle (not counted for point clouds)
    std::uint64_t negative_index_count = 0;   ///< relative (negative) OBJ indices, resolved
    std::uint64_t ignored_line_count = 0;     ///< OBJ statements other than v and f
    std::uint64_t ignored_element_count = 0;  ///< rows of PLY elements that hold no triangles
    std::uint64_t trailing_byte_count = 0;    ///< bytes after the last row of a PLY or OFF file
    std::uint64_t warning_count = 0;          ///< number of Assimp's warnings
    std::vector<std::string> warnings;        ///< the first of Assimp's warnings
};

/// True if the library was built with Assimp, which reads STL, glTF, COLLADA and others. Without
/// Assimp, load_mesh() throws Error(unsupported) for these formats and says how to enable them.
[[nodiscard]] COPPICE_EXPORT bool can_load_scene_files() noexcept;

/// Reads a triangle mesh. The extension selects the format: .obj and .ply, both also gzipped
/// (.obj.gz, .ply.gz), .off, and, if the library was built with Assimp, .stl, .gltf, .glb, .dae,
/// .x3d, .3ds, .fbx and others. A file without an extension is recognized as OBJ, PLY or OFF by its
/// first bytes. Polygons are cut into fans, and all scene transforms are applied. A PLY file
/// without faces is a point cloud: a mesh without triangles. Vertices keep their order and are not
/// merged (OBJ, PLY). Coordinates are rounded to the nearest floats.
///
/// `report`, if not null, receives the counts of all irregularities. `attributes`, if not null,
/// receives materials (OBJ with its MTL files, Assimp) and normals (OBJ, PLY, Assimp). Missing or
/// malformed attributes become warnings there; if it is null, attributes are ignored.
///
/// Throws Error (io, parse, unsupported, limit, out_of_memory) naming the file, and the 1-based
/// line for text in OBJ, PLY and OFF files (for a statement of several lines, its first line).
/// Causes: a missing or empty file, a directory or device, an unknown extension, malformed or
/// out-of-range indices, coordinates that are NaN, infinite or beyond the range of float, no faces,
/// truncated data.
[[nodiscard]] COPPICE_EXPORT TriangleMesh load_mesh(const std::filesystem::path& file,
                                                    LoadReport* report = nullptr,
                                                    MeshAttributes* attributes = nullptr);

}  // namespace coppice::inline v0
