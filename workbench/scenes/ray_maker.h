#pragma once

#include "coppice/geom/ray.h"
#include "coppice/geom/triangle_mesh.h"

#include "scenes/camera.h"
#include "scenes/ray_sets.h"
#include "tracers/traced_tree.h"

#include <cstdint>
#include <vector>

namespace coppice::lab {

/// What rays depend on, besides the mesh.
struct RayOptions {
    render::Camera camera;
    Vec3f light;
    int size = 1000;         ///< up to so many rays of each kind, squared; >= 1
    std::uint64_t seed = 1;  ///< of directions
};

/// Makes rays of all kinds for one scene. Mesh and tree must outlive it.
class RayMaker {
public:
    /// `tree` is one over the mesh, to find where secondary rays start.
    RayMaker(TriangleMeshView mesh, const TracedTree& tree, const RayOptions& options)
        : mesh_(mesh), tree_(tree), options_(options) {}

    /// size * size rays; fewer shadow and diffuse ones if the camera sees nothing, or little.
    /// Throws like CameraRays.
    [[nodiscard]] std::vector<Ray> make(RayKind kind);

private:
    void see_surfaces();
    std::size_t look(int size);

    TriangleMeshView mesh_;
    const TracedTree& tree_;
    RayOptions options_;
    std::vector<Ray> seen_rays_;
    std::vector<Hit> seen_hits_;
};

}  // namespace coppice::lab
