#pragma once

#include "coppice/geom/triangle_mesh.h"

#include "scenes/camera.h"
#include "tracers/traced_tree.h"

namespace coppice::lab {

/// A camera, with what was not given chosen for it.
struct ChosenCamera {
    render::Camera camera;
    bool is_inside = false;  ///< of a room
};

/// The camera for pictures of a mesh: what is wished for, and around it what frames all vertices;
/// or, if neither eye nor point to look at is wished for and the mesh is a room (closed all around,
/// with half as much again to see inside as from outside), a good place inside. The tracer is of
/// the mesh. Throws like frame_points().
[[nodiscard]] ChosenCamera choose_camera(TriangleMeshView mesh, const TracedTree& tracer,
                                         const render::CameraWish& wish, double aspect);

/// The same for rays that are measured, of a square image: around the box of the mesh, or inside.
/// Builds a tree by `fast` with at most `threads` threads if it has to look.
[[nodiscard]] render::Camera choose_ray_camera(TriangleMeshView mesh,
                                               const render::CameraWish& wish, int threads);

}  // namespace coppice::lab
