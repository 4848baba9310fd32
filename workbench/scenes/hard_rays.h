#pragma once

#include "coppice/geom/ray.h"
#include "coppice/geom/triangle_mesh.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace coppice::lab {

/// Rays of the kinds that traversals get wrong. Ray i depends on the mesh and (seed, i) alone; all
/// start with t_min = 0 and have no end. None for a mesh without triangles.

/// Random lines through the scene's box, uniform: a convex body in the box is met with the
/// probability that its surface area is of the box's. They start outside the box.
[[nodiscard]] std::vector<Ray> random_rays(TriangleMeshView mesh, std::size_t count,
                                           std::uint64_t seed);

/// Rays parallel to an axis, either way, through a random triangle's corner, from outside the box.
/// The other two components of the direction are zeros of either sign.
[[nodiscard]] std::vector<Ray> axis_rays(TriangleMeshView mesh, std::size_t count,
                                         std::uint64_t seed);

/// Rays through two points of a random triangle, so that they run in its plane as far as float
/// allows. They start in front of it, by up to the size of the scene.
[[nodiscard]] std::vector<Ray> grazing_rays(TriangleMeshView mesh, std::size_t count,
                                            std::uint64_t seed);

}  // namespace coppice::lab
