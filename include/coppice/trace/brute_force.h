#pragma once

#include "coppice/geom/ray.h"
#include "coppice/geom/triangle_mesh.h"

#include <optional>

namespace coppice {

/// The closest hit of a ray, by testing every triangle: the oracle of all traversals. Of hits at
/// the same distance the lowest id wins. A bad ray (NaN, zero direction, t_min > t_max) hits
/// nothing.
[[nodiscard]] std::optional<Hit> brute_force_intersect(TriangleMeshView mesh,
                                                       const Ray& ray) noexcept;

/// True if any triangle is hit.
[[nodiscard]] bool brute_force_occluded(TriangleMeshView mesh, const Ray& ray) noexcept;

}  // namespace coppice
