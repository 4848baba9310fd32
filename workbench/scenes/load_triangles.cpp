#include "scenes/load_triangles.h"

#include "coppice/base/error.h"

namespace coppice::lab {

TriangleMesh load_triangles(const std::filesystem::path& file, LoadReport* report,
                            MeshAttributes* attributes) {
    TriangleMesh mesh = load_mesh(file, report, attributes);
    if (!mesh.triangles.empty()) return mesh;
    throw file_error(ErrorCode::unsupported, file.string(),
                     "has no triangles for rays to hit; give a mesh, not a point cloud");
}

}  // namespace coppice::lab
