#pragma once

#include "coppice/build/build_control.h"
#include "coppice/build/build_options.h"
#include "coppice/build/build_report.h"
#include "coppice/geom/primitive_set.h"
#include "coppice/geom/triangle_mesh.h"
#include "coppice/tree/kd_tree.h"
#include "coppice/tree/wide_bvh.h"

namespace coppice {

/// The whole pipeline: sample, build, empty, refill, refine, measure. Deterministic: the same
/// primitives, options and seed give the same tree, bit for bit, for any number of threads.
/// If `report` is given it receives the stage times and the measured tree.
/// Throws Error(invalid_argument) for options out of range and for the first primitive whose box
/// is not finite, Error(limit) for too many references and a memory limit, Error(cancelled) after a
/// stop, Error(out_of_memory); whatever it throws, nothing is left behind.
[[nodiscard]] KdTree build_kd_tree(PrimitiveSetView primitives, const BuildOptions& options = {},
                                   BuildReport* report = nullptr, const BuildControl& control = {});

/// The same with an 8-wide tree as the result, as `options.wide` says: a top from a sample, all
/// triangles filled into its cells, and every cell built on by object splits. `options.sample`
/// applies from `options.wide.sampled_from` triangles on; `report` has the sample as it was drawn.
/// `options.cost` is only what the finished tree is measured by; `options.split` and
/// `options.growth` do not apply. The tree keeps a copy of the triangles' corners.
/// Throws Error(limit) for more than 2^30 triangles, too.
[[nodiscard]] WideBvh build_wide_bvh(TriangleMeshView mesh, const BuildOptions& options = {},
                                     BuildReport* report = nullptr,
                                     const BuildControl& control = {});

}  // namespace coppice
