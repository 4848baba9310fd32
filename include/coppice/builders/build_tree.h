#pragma once

#include "coppice/builders/build_control.h"
#include "coppice/builders/build_report.h"
#include "coppice/builders/bvh8_options.h"
#include "coppice/builders/kd_options.h"
#include "coppice/export.h"
#include "coppice/geom/primitive_set.h"
#include "coppice/geom/triangle_mesh.h"
#include "coppice/tree/bvh8.h"
#include "coppice/tree/kd_tree.h"

namespace coppice::inline v0 {

/// The result of build_kd_tree().
struct KdBuild {
    KdTree tree;         ///< what was built
    BuildReport report;  ///< what that took
};

/// The result of build_bvh8().
struct Bvh8Build {
    Bvh8 tree;           ///< what was built
    BuildReport report;  ///< what that took
};

/// Builds a k-d tree with the whole pipeline: sample, build, empty, refill, refine, measure.
/// Deterministic: equal primitives, options and seed give the same tree to the bit, for any number
/// of threads. Throws Error: invalid_argument for options out of range, for the first primitive
/// that is invalid (see PrimitiveSet) and for the first whose box is not finite; limit for too many
/// references or an exceeded memory limit; cancelled after a stop request; out_of_memory. After an
/// error, all memory has been freed.
[[nodiscard]] COPPICE_EXPORT KdBuild build_kd_tree(PrimitiveSetView primitives,
                                                   const KdOptions& options = {},
                                                   const BuildControl& control = {});

/// Builds an 8-wide tree: a top tree from a sample, all triangles filled into its cells, and every
/// cell refined by object splits. The tree keeps a copy of the triangles' corners. Deterministic
/// like build_kd_tree(). Throws as build_kd_tree() does, and Error(limit) for more than 2^30
/// triangles.
[[nodiscard]] COPPICE_EXPORT Bvh8Build build_bvh8(TriangleMeshView mesh,
                                                  const Bvh8Options& options = {},
                                                  const BuildControl& control = {});

}  // namespace coppice::inline v0
