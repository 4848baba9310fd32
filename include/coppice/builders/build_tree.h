#pragma once

#include "coppice/builders/build_control.h"
#include "coppice/builders/build_options.h"
#include "coppice/builders/build_report.h"
#include "coppice/geom/primitive_set.h"
#include "coppice/geom/triangle_mesh.h"
#include "coppice/tree/bvh8.h"
#include "coppice/tree/kd_tree.h"

namespace coppice::inline v0 {

/// The whole pipeline: sample, build, empty, refill, refine, measure. Deterministic: the same
/// primitives, options and seed give the same tree, bit for bit, for any number of threads.
/// If `report` is given it receives the stage times and the measured tree.
/// Throws Error(invalid_argument) for options out of range and for the first primitive whose box
/// is not finite, Error(limit) for too many references and a memory limit, Error(cancelled) after a
/// stop, Error(out_of_memory); whatever it throws, nothing is left behind.
[[nodiscard]] KdTree build_kd_tree(PrimitiveSetView primitives, const BuildOptions& options = {},
                                   BuildReport* report = nullptr, const BuildControl& control = {});

/// The same with an 8-wide tree as the result, as `options.bvh8` says: a top from a sample, all
/// triangles filled into its cells, and every cell built on by object splits. `options.sample`
/// applies from `options.bvh8.sampled_from` triangles on; `report` has the sample as it was drawn.
/// `options.cost` is only what the finished tree is measured by; `options.split` and
/// `options.growth` do not apply. The tree keeps a copy of the triangles' corners.
/// Throws Error(limit) for more than 2^30 triangles, too.
[[nodiscard]] Bvh8 build_bvh8(TriangleMeshView mesh, const BuildOptions& options = {},
                              BuildReport* report = nullptr, const BuildControl& control = {});

}  // namespace coppice::inline v0
