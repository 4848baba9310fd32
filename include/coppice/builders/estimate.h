#pragma once

#include "coppice/builders/build_report.h"
#include "coppice/builders/bvh8_options.h"
#include "coppice/builders/kd_options.h"
#include "coppice/export.h"
#include "coppice/geom/primitive_set.h"
#include "coppice/geom/triangle_mesh.h"

#include <stop_token>

namespace coppice::inline v0 {

/// What build_kd_tree() is expected to come to with these primitives and options: from building a
/// sixteenth of the scene, in pieces from all over it. Takes about a fifth of the time of the
/// build, of an 8-wide tree's up to half. The seconds are for memory that the process has not
/// touched yet. All but the seconds depends on primitives and options alone; these are of this
/// machine, now. Throws like build_kd_tree().
[[nodiscard]] COPPICE_EXPORT BuildEstimate estimate_kd_tree(PrimitiveSetView primitives,
                                                            const KdOptions& options = {},
                                                            const std::stop_token& stop = {});

/// The same of build_bvh8().
[[nodiscard]] COPPICE_EXPORT BuildEstimate estimate_bvh8(TriangleMeshView mesh,
                                                         const Bvh8Options& options = {},
                                                         const std::stop_token& stop = {});

}  // namespace coppice::inline v0
