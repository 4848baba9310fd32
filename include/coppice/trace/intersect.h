#pragma once

#include "coppice/geom/ray.h"
#include "coppice/geom/triangle_mesh.h"
#include "coppice/tree/kd_tree.h"

#include <optional>

namespace coppice {

/// The closest hit of a ray in a mesh, found with a tree over its triangles. Equals
/// brute_force_intersect(), the lowest id of equally close hits included. Allocates nothing.
[[nodiscard]] std::optional<Hit> intersect(const KdTree& tree, TriangleMeshView mesh,
                                           const Ray& ray) noexcept;

/// True if the ray hits any triangle; may stop at the first.
[[nodiscard]] bool occluded(const KdTree& tree, TriangleMeshView mesh, const Ray& ray) noexcept;

}  // namespace coppice
