#include "coppice/store/fingerprint.h"

#include "store/checksum.h"

#include <fmt/format.h>

namespace coppice::inline v0 {

Fingerprint fingerprint_of(TriangleMeshView mesh) {
    return {mesh.size(), mesh.vertices().size(), checksum(std::as_bytes(mesh.vertices())),
            checksum(std::as_bytes(mesh.triangles()))};
}

Fingerprint fingerprint_of(PointCloudView points) {
    return {points.size(), points.size(), checksum(std::as_bytes(points.points())), 0};
}

std::string difference(const Fingerprint& wanted, const Fingerprint& found) {
    if (wanted.primitive_count != found.primitive_count) {
        return fmt::format("{} primitives, not {}", wanted.primitive_count, found.primitive_count);
    }
    if (wanted.vertex_count != found.vertex_count) {
        return fmt::format("{} vertices, not {}", wanted.vertex_count, found.vertex_count);
    }
    if (wanted.vertex_hash != found.vertex_hash) return "its vertex positions differ";
    if (wanted.index_hash != found.index_hash) return "its vertex indices differ";
    return {};
}

}  // namespace coppice::inline v0
