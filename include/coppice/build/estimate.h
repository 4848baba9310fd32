#pragma once

#include "coppice/build/build_options.h"
#include "coppice/build/build_report.h"
#include "coppice/geom/primitive_set.h"
#include "coppice/geom/triangle_mesh.h"

#include <stop_token>

namespace coppice {

/// What build_kd_tree() is expected to come to with these primitives and options: from building a
/// sixteenth of the scene, in pieces from all over it. Takes about a fifth of the time of the
/// build, of a wide tree's up to half. The seconds are for memory that the process has not touched
/// yet. All but the seconds depends on primitives and options alone; these are of this machine,
/// now. Throws like build_kd_tree().
[[nodiscard]] Estimate estimate_kd_tree(PrimitiveSetView primitives, const BuildOptions& options,
                                        const std::stop_token& stop = {});

/// The same of build_wide_bvh().
[[nodiscard]] Estimate estimate_wide_bvh(TriangleMeshView mesh, const BuildOptions& options,
                                         const std::stop_token& stop = {});

}  // namespace coppice
