#include "io/loaded_mesh.h"

#include "coppice/base/error.h"

#include <fmt/format.h>

#include <limits>

namespace coppice::inline v0 {

namespace {

constexpr std::size_t max_count = std::numeric_limits<std::uint32_t>::max();

}  // namespace

void add_vertex(LoadedMesh& loaded, Vec3f position) {
    if (loaded.mesh.vertices.size() == max_count) {
        throw file_error(ErrorCode::limit, loaded.report.file,
                         fmt::format("more than {} vertices", max_count));
    }
    loaded.mesh.vertices.push_back(position);
}

void add_face(LoadedMesh& loaded, std::span<const std::uint32_t> corners) {
    LoadReport& report = loaded.report;
    const std::uint64_t face = report.face_count++;
    if (corners.size() < 3) {
        report.degenerate_faces.add(face);
        return;
    }
    if (corners.size() > 3) {
        report.polygons.add(face);
    }
    if (loaded.mesh.triangles.size() + corners.size() - 2 > max_count) {
        throw file_error(ErrorCode::limit, report.file,
                         fmt::format("more than {} triangles", max_count));
    }
    for (std::size_t i = 2; i < corners.size(); ++i) {
        loaded.mesh.triangles.push_back({corners[0], corners[i - 1], corners[i]});
    }
}

void check_has_triangles(const LoadedMesh& loaded) {
    if (!loaded.mesh.triangles.empty()) {
        return;
    }
    throw file_error(
        ErrorCode::parse, loaded.report.file,
        loaded.report.face_count == 0 ? "no faces" : "no faces of three or more corners");
}

}  // namespace coppice::inline v0
