#pragma once

#include "coppice/builders/build_control.h"
#include "coppice/builders/build_report.h"
#include "coppice/builders/method.h"
#include "coppice/geom/ray.h"
#include "coppice/geom/triangle_mesh.h"
#include "coppice/store/tree_file.h"
#include "coppice/trace/traversal_counts.h"

#include <memory>
#include <optional>

namespace coppice::render {

/// What the renderer asks of a tree, whichever kind it is.
class RayTracer {
public:
    RayTracer() = default;
    RayTracer(const RayTracer&) = delete;
    RayTracer& operator=(const RayTracer&) = delete;
    virtual ~RayTracer() = default;

    /// The closest hit, or nothing.
    [[nodiscard]] virtual std::optional<Hit> intersect(const Ray& ray) const noexcept = 0;

    /// The same, and adds what it took to `counts`.
    [[nodiscard]] virtual std::optional<Hit> intersect(const Ray& ray,
                                                       TraversalCounts& counts) const noexcept = 0;

    /// True if anything lies on the ray.
    [[nodiscard]] virtual bool occluded(const Ray& ray) const noexcept = 0;
};

/// What traces a tree that there is, over a mesh, which must outlive the tracer.
[[nodiscard]] std::unique_ptr<RayTracer> make_tracer(AnyTree tree, TriangleMeshView mesh);

/// A tree of either kind, and how it was built.
struct AnyBuild {
    AnyTree tree;
    BuildReport report;
};

/// Builds a tree by options of either kind. Throws Error like build_kd_tree() and build_bvh8().
[[nodiscard]] AnyBuild build_tree(TriangleMeshView mesh, const BuildOptions& options,
                                  const BuildControl& control = {});

/// What pictures of a mesh are traced with: the tree `fast`, built for it by at most `threads`
/// threads. The mesh must outlive it. Throws like build_bvh8().
[[nodiscard]] std::unique_ptr<RayTracer> picture_tracer(TriangleMeshView mesh, int threads,
                                                        const BuildControl& control = {});

}  // namespace coppice::render
