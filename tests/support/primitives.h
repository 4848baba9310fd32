#pragma once

#include "coppice/geom/point_cloud.h"
#include "coppice/geom/primitive_set.h"
#include "coppice/geom/triangle_mesh.h"

#include <utility>

namespace coppice::test {

/// What of a mesh a tree is built on.
enum class PrimitiveKind { triangles, points };

/// A mesh and both sets of primitives that it has.
class Primitives {
public:
    explicit Primitives(TriangleMesh mesh)
        : mesh_(std::move(mesh)), triangles_(mesh_.view()), points_(mesh_.vertices) {}

    Primitives(const Primitives&) = delete;
    Primitives& operator=(const Primitives&) = delete;

    [[nodiscard]] PrimitiveSetView of(PrimitiveKind kind) const {
        if (kind == PrimitiveKind::points) return points_;
        return triangles_;
    }

    [[nodiscard]] const TriangleMesh& mesh() const { return mesh_; }

private:
    TriangleMesh mesh_;
    TriangleMeshView triangles_;
    PointCloudView points_;
};

}  // namespace coppice::test
