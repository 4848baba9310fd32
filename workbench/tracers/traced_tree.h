#pragma once

#include "coppice/builders/build_control.h"
#include "coppice/builders/build_report.h"
#include "coppice/builders/method.h"
#include "coppice/geom/triangle_mesh.h"
#include "coppice/store/tree_file.h"
#include "coppice/trace/bvh8_tracer.h"
#include "coppice/trace/traversal_counts.h"
#include "coppice/tree/kd_tree.h"

#include <optional>

namespace coppice::lab {

/// A tree of either kind behind one type, for rays. Queries may run on several threads at once. The
/// mesh must outlive it.
class TracedTree {
public:
    /// Builds the tree. Throws like build_kd_tree() and build_bvh8().
    TracedTree(TriangleMeshView mesh, const BuildOptions& options,
               const BuildControl& control = {});

    /// Takes a tree over that mesh.
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

/// A tree of either kind, and how it was built.
struct AnyBuild {
    AnyTree tree;
    BuildReport report;
};

/// Builds a tree by options of either kind. Throws Error like build_kd_tree() and build_bvh8().
[[nodiscard]] AnyBuild build_tree(TriangleMeshView mesh, const BuildOptions& options,
                                  const BuildControl& control = {});

/// What pictures of a mesh are traced with: the tree `fast`, built by at most `threads` threads.
/// The mesh must outlive it. Throws like build_bvh8().
[[nodiscard]] TracedTree build_picture_tree(TriangleMeshView mesh, int threads,
                                            const BuildControl& control = {});

}  // namespace coppice::lab
