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

/// A k-d tree and how it was built.
struct KdBuild {
    KdTree tree;         ///< what was built
    BuildReport report;  ///< what that took
};

/// An 8-wide tree and how it was built.
struct Bvh8Build {
    Bvh8 tree;           ///< what was built
    BuildReport report;  ///< what that took
};

/// The whole pipeline: sample, build, empty, refill, refine, measure. Deterministic: the same
/// primitives, options and seed give the same tree, bit for bit, for any number of threads.
/// Throws Error(invalid_argument) for options out of range, for the first primitive that is not
/// valid (see PrimitiveSet) and for the first whose box is not finite, Error(limit) for too many
/// references and a memory limit, Error(cancelled) after a stop, Error(out_of_memory); whatever it
/// throws, nothing is left behind.
[[nodiscard]] COPPICE_EXPORT KdBuild build_kd_tree(PrimitiveSetView primitives,
                                                   const KdOptions& options = {},
                                                   const BuildControl& control = {});

/// The same with an 8-wide tree as the result: a top from a sample, all triangles filled into its
/// cells, and every cell built on by object splits. The tree keeps a copy of the triangles'
/// corners. Throws Error(limit) for more than 2^30 triangles, too.
[[nodiscard]] COPPICE_EXPORT Bvh8Build build_bvh8(TriangleMeshView mesh,
                                                  const Bvh8Options& options = {},
                                                  const BuildControl& control = {});

}  // namespace coppice::inline v0
