#pragma once

#include "coppice/geom/triangle_mesh.h"
#include "coppice/io/load_mesh.h"

namespace coppice::inline v0 {

/// Counts the irregularities of a mesh in `report`: zero-area triangles, duplicates, unused
/// vertices. Linear in time and memory (about 12 bytes a triangle and 20 a vertex).
void count_load_issues(TriangleMeshView mesh, LoadReport& report);

}  // namespace coppice::inline v0
