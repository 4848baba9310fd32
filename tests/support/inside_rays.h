#pragma once

#include "coppice/geom/ray.h"
#include "coppice/geom/triangle_mesh.h"

#include "support/random.h"

#include <array>
#include <cstdint>
#include <vector>

namespace coppice::test {

/// Rays from inside of a closed mesh, of which each hits it: into any direction, at vertices, at
/// points of edges, and within planes of trees over it. A mesh is closed here if every edge has an
/// even number of triangles. Coordinates on a grid make the aim exact.
class InsideRays {
public:
    /// Finds points inside. Throws std::runtime_error if it finds none.
    InsideRays(const TriangleMesh& mesh, std::uint64_t seed);

    /// Ray number `number`, whatever was asked for before.
    [[nodiscard]] Ray make(std::uint64_t number) const;

private:
    struct PlanePoint {
        Vec3f point;
        Axis axis;
    };

    [[nodiscard]] Vec3f target(Random& random) const;
    [[nodiscard]] Ray in_plane(Random& random) const;

    TriangleMeshView mesh_;
    std::uint64_t seed_;
    std::vector<Vec3f> points_;
    std::vector<PlanePoint> plane_points_;  // inside, and in a plane of a tree
};

/// `mesh` with its vertices on a grid, then moved: closed as before, though triangles may lose
/// their area.
[[nodiscard]] TriangleMesh on_grid(TriangleMesh mesh, float step, Vec3f moved_by);

}  // namespace coppice::test
