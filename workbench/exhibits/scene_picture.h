#pragma once

#include "coppice/builders/build_control.h"
#include "coppice/geom/triangle_mesh.h"
#include "coppice/io/mesh_attributes.h"
#include "coppice/tree/kd_tree.h"

#include "report/exhibits.h"
#include "scenes/camera.h"
#include "tracers/traced_tree.h"

#include <memory>

namespace coppice::lab {

/// What pictures are taken of: a mesh with at least one triangle.
struct PictureScene {
    TriangleMeshView mesh;
    const MeshAttributes* attributes;
    render::Camera camera;
    int threads = 0;  ///< at most so many; 0 = all the hardware has
};

/// The scene as `coppice render` shows it, in 960 x 540 pixels of 4 samples.
[[nodiscard]] report::Picture render_picture(const PictureScene& scene, const TracedTree& tracer);

/// What the same camera's rays take in trees over the scene's triangles, in 640 x 360 pixels of 2
/// samples: of `full` alone or, with `other`, of both on one scale, and the difference.
[[nodiscard]] report::HeatMaps render_heat_maps(const PictureScene& scene, const KdTree& full,
                                                const KdTree* other);

}  // namespace coppice::lab
