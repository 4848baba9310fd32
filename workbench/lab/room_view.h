#pragma once

#include "coppice/geom/triangle_mesh.h"

#include "render/camera.h"
#include "render/ray_tracer.h"

#include <optional>

namespace coppice::lab {

/// A camera inside a mesh that is a room: closed all around, with more to see from inside than
/// from `outside`. Nothing for any other mesh. `tracer` is of the mesh.
[[nodiscard]] std::optional<render::Camera> view_of_room(TriangleMeshView mesh,
                                                         const render::RayTracer& tracer,
                                                         const render::Camera& outside);

}  // namespace coppice::lab
