#pragma once

#include "coppice/export.h"
#include "coppice/geom/point_cloud.h"
#include "coppice/geom/triangle_mesh.h"

#include <cstdint>
#include <string>

namespace coppice::inline v0 {

/// What tells the primitives of one tree from those of others: their number, and hashes of the
/// bytes of their arrays (XXH3, pieces of 1 MiB in parallel). For primitives of your own fill it in
/// as you like.
struct Fingerprint {
    std::uint64_t primitive_count = 0;  ///< triangles, or points
    std::uint64_t vertex_count = 0;     ///< of a mesh all of them, used or not
    std::uint64_t vertex_hash = 0;      ///< of the vertices' coordinates
    std::uint64_t index_hash = 0;       ///< of the triangles' corners; 0 for points

    friend constexpr bool operator==(const Fingerprint&, const Fingerprint&) = default;
};

/// The fingerprint of a mesh. A bit that differs in any coordinate or index shows.
[[nodiscard]] COPPICE_EXPORT Fingerprint fingerprint_of(TriangleMeshView mesh);

/// The fingerprint of points.
[[nodiscard]] COPPICE_EXPORT Fingerprint fingerprint_of(PointCloudView points);

/// What is different, in words for an error: "871414 primitives, not 12"; "" for equal ones.
[[nodiscard]] COPPICE_EXPORT std::string difference(const Fingerprint& wanted,
                                                    const Fingerprint& found);

}  // namespace coppice::inline v0
