#pragma once

#include "coppice/geom/triangle_mesh.h"
#include "coppice/io/load_mesh.h"

#include <cstdint>
#include <span>

namespace coppice::inline v0 {

/// The result of every reader: a mesh and the report on it.
struct LoadedMesh {
    TriangleMesh mesh;
    LoadReport report;
};

/// Appends a vertex. Throws Error(limit) at 2^32 - 1 vertices.
void add_vertex(LoadedMesh& loaded, Vec3f position);

/// Appends a face of any number of corners as a fan of triangles around its first corner, and
/// counts it. All corners must be ids of vertices. Throws Error(limit) at 2^32 - 1 triangles.
void add_face(LoadedMesh& loaded, std::span<const std::uint32_t> corners);

/// Throws Error(parse) if the mesh has no triangles.
void check_has_triangles(const LoadedMesh& loaded);

}  // namespace coppice::inline v0
