#pragma once

#include "coppice/builders/build_control.h"
#include "coppice/geom/triangle_mesh.h"

#include <cstdint>
#include <span>

namespace coppice::lab {

/// Bytes of a mesh's arrays.
[[nodiscard]] inline std::uint64_t byte_count(TriangleMeshView mesh) noexcept {
    return mesh.vertices().size_bytes() + mesh.triangles().size_bytes();
}

/// The limit on what a mesh, the points made of it and a build may take together; 0: none.
[[nodiscard]] inline BuildControl limit_memory(std::uint64_t limit_bytes, TriangleMeshView mesh,
                                               std::span<const Vec3f> points = {}) noexcept {
    return {.memory_limit_bytes = limit_bytes,
            .primitive_bytes = byte_count(mesh) + points.size_bytes()};
}

}  // namespace coppice::lab
