#pragma once

#include "coppice/build/build_options.h"
#include "coppice/build/build_report.h"
#include "coppice/geom/primitive_set.h"
#include "coppice/tree/kd_tree.h"

namespace coppice {

/// The whole pipeline: sample, build, empty, refill, refine, measure. Deterministic: the same
/// primitives, options and seed give the same tree, bit for bit, for any number of threads.
/// If `report` is given it receives the stage times and the measured tree.
/// Throws Error(invalid_argument) for options out of range and for the first primitive whose box
/// is not finite, Error(limit) for too many references.
[[nodiscard]] KdTree build_kd_tree(PrimitiveSetView primitives, const BuildOptions& options = {},
                                   BuildReport* report = nullptr);

}  // namespace coppice
