#pragma once

#include "coppice/builders/build_control.h"
#include "coppice/builders/method.h"
#include "coppice/geom/triangle_mesh.h"
#include "coppice/store/tree_file.h"
#include "coppice/trace/bvh8_tracer.h"
#include "coppice/trace/traversal_counts.h"
#include "coppice/tree/kd_tree.h"

#include <optional>

namespace coppice::lab {

/// A tree of either kind behind one type, for rays. The mesh must outlive it.
class TracedTree {
public:
    /// Builds the tree. Throws like build_kd_tree() and build_bvh8().
    TracedTree(TriangleMeshView mesh, const BuildOptions& options,
               const BuildControl& control = {});

    /// Takes a tree that there is, over that mesh.
    TracedTree(TriangleMeshView mesh, AnyTree tree);

    /// The closest hit, or nothing.
    [[nodiscard]] std::optional<Hit> intersect(const Ray& ray) const noexcept;
    [[nodiscard]] std::optional<Hit> intersect(const Ray& ray,
                                               TraversalCounts& counts) const noexcept;

    /// True if the ray hits any triangle.
    [[nodiscard]] bool occluded(const Ray& ray) const noexcept;
    [[nodiscard]] bool occluded(const Ray& ray, TraversalCounts& counts) const noexcept;

private:
    TriangleMeshView mesh_;
    KdTree kd_;
    std::optional<Bvh8Tracer> bvh8_;  // in place of kd_
};

}  // namespace coppice::lab
