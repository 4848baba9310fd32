#pragma once

#include "coppice/geom/ray.h"
#include "coppice/geom/triangle_mesh.h"
#include "coppice/io/mesh_attributes.h"

namespace coppice::render {

/// Where a ray met a mesh, as far as shading needs to know.
struct Surface {
    Vec3d position;
    Vec3d facing;              ///< unit, at right angles to the triangle, where the ray came from
    Vec3d normal;              ///< unit, interpolated if the mesh has normals, on the same side
    const Material* material;  ///< never null
    double offset;             ///< more than what rounding may have moved `position` by

    /// Where a ray that leaves the surface on the side of `facing` starts: a little off it, so that
    /// it does not meet the surface itself.
    [[nodiscard]] Vec3f start() const noexcept;
};

/// The surface at a hit; `attributes` are those of `mesh`, and must outlive the result.
[[nodiscard]] Surface surface_at(TriangleMeshView mesh, const MeshAttributes& attributes,
                                 const Ray& ray, const Hit& hit) noexcept;

/// The material of a triangle; grey if it has none.
[[nodiscard]] const Material& material_of(const MeshAttributes& attributes,
                                          std::uint32_t triangle) noexcept;

/// A point of a triangle, 1 - u - v of its first corner, u of its second, v of its third, and how
/// far off rays have to start there.
struct TrianglePoint {
    Vec3d position;
    double offset;
};

[[nodiscard]] TrianglePoint point_on(const Triangle& triangle, double u, double v) noexcept;

}  // namespace coppice::render
