#pragma once

#include "coppice/export.h"
#include "coppice/geom/point_cloud.h"
#include "coppice/geom/triangle_mesh.h"

#include <cstdint>
#include <string>

namespace coppice::inline v0 {

/// Identifies the primitives that a tree was built for: their number and hashes of the bytes of
/// their arrays (XXH3, 1 MiB pieces in parallel). For a primitive set of your own, fill in any
/// numbers that identify it.
struct Fingerprint {
    std::uint64_t primitive_count = 0;  ///< number of triangles or points
    std::uint64_t vertex_count = 0;     ///< number of a mesh's vertices, used or not
    std::uint64_t vertex_hash = 0;      ///< hash of the coordinates
    std::uint64_t index_hash = 0;       ///< hash of the triangles' indices; 0 for points

    friend constexpr bool operator==(const Fingerprint&, const Fingerprint&) = default;
};

/// The fingerprint of a mesh. It changes if any bit of a coordinate or index changes.
[[nodiscard]] COPPICE_EXPORT Fingerprint fingerprint_of(TriangleMeshView mesh);

/// The fingerprint of points.
[[nodiscard]] COPPICE_EXPORT Fingerprint fingerprint_of(PointCloudView points);

/// The difference of two fingerprints in words, for an error message: "871414 primitives, not 12".
/// Empty if they are equal.
[[nodiscard]] COPPICE_EXPORT std::string difference(const Fingerprint& wanted,
                                                    const Fingerprint& found);

}  // namespace coppice::inline v0
