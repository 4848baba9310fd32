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

/// How often something odd but legal was met in a file, and the first places of it.
struct COPPICE_EXPORT LoadIssue {
    /// So many places are named.
    static constexpr std::size_t kept_places = 8;

    std::uint64_t count = 0;  ///< how often it was met
    /// 0-based ids of the first faces, triangles or vertices concerned, at most `kept_places`.
    std::vector<std::uint64_t> first;

    /// Counts one more, at `place`.
    void add(std::uint64_t place);
};

/// What a file held and what was odd about it. Nothing is dropped without being counted here.
struct LoadReport {
    std::string file;                  ///< as it was given
    std::string format;                ///< "obj", "ply", "off" or Assimp's name of the format
    std::uint64_t file_bytes = 0;      ///< on disk
    double load_seconds = 0.0;         ///< reading and counting
    std::uint64_t vertex_count = 0;    ///< vertices in the mesh
    std::uint64_t face_count = 0;      ///< faces in the file, before polygons become triangles
    std::uint64_t triangle_count = 0;  ///< triangles in the mesh
    LoadIssue polygons;             ///< faces of more than three corners, cut into fans (face ids)
    LoadIssue degenerate_faces;     ///< faces of fewer than three corners, not triangles (face ids)
    LoadIssue zero_area_triangles;  ///< kept: they are primitives that no ray hits (triangle ids)
    LoadIssue duplicate_triangles;  ///< kept: same corner positions as an earlier one, in any order
    LoadIssue
        duplicate_vertices;     ///< kept: same position as an earlier vertex; -0 and +0 are equal
    LoadIssue unused_vertices;  ///< kept: in no triangle (none of a point cloud counts)
    std::uint64_t negative_index_count = 0;   ///< relative (negative) OBJ indices, resolved
    std::uint64_t ignored_line_count = 0;     ///< OBJ statements other than v and f
    std::uint64_t ignored_element_count = 0;  ///< rows of PLY elements that hold no triangles
    std::uint64_t trailing_byte_count = 0;    ///< behind the last row of a PLY or OFF file
    std::uint64_t warning_count = 0;          ///< of Assimp
    std::vector<std::string> warnings;        ///< the first of them
};

/// True if the library was built with Assimp, which reads STL, glTF, COLLADA and others; without it
/// load_mesh() refuses them, naming what is missing.
[[nodiscard]] COPPICE_EXPORT bool can_load_scene_files() noexcept;

/// Reads a triangle mesh: .obj, .ply, both also gzipped (.obj.gz, .ply.gz),
/// .off (a file whose name has no extension is taken for what it begins like of these), and
/// through Assimp, where there is one, .stl, .gltf, .glb, .dae, .x3d, .3ds, .fbx and others by file
/// name. Polygons are cut into fans; all scene transforms are applied. A PLY file without faces is
/// a point cloud and gives a mesh with no triangles. Vertices keep their order and are not merged
/// (OBJ, PLY). Coordinates become the nearest floats.
/// If `report` is given it receives counts of all that was odd. If `attributes` is given it
/// receives materials (OBJ with its MTL files, Assimp) and normals (OBJ, PLY, Assimp); what of them
/// is missing or malformed becomes a warning there. Otherwise both are passed over. Throws Error
/// (io, parse, unsupported, limit, out_of_memory) naming the file, and the 1-based line for text in
/// OBJ, PLY and OFF files (the first line of a statement that goes on over several): missing or
/// empty file, directory, device, unknown extension, malformed or out-of-range indices, NaN or
/// infinite coordinates or such beyond the range of float, no faces, truncated data.
[[nodiscard]] COPPICE_EXPORT TriangleMesh load_mesh(const std::filesystem::path& file,
                                                    LoadReport* report = nullptr,
                                                    MeshAttributes* attributes = nullptr);

}  // namespace coppice::inline v0
