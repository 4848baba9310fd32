#pragma once

#include "coppice/builders/build_report.h"
#include "coppice/builders/bvh8_options.h"
#include "coppice/builders/kd_options.h"
#include "coppice/export.h"
#include "coppice/geom/primitive_set.h"
#include "coppice/geom/triangle_mesh.h"

#include <stop_token>

namespace coppice::inline v0 {

/// The greatest relative error of estimated references and bytes, and of the peak bytes of an
/// 8-wide build, that the tests accept on a terrain and on a soup of triangles. Scenes whose parts
/// differ much are estimated worse.
inline constexpr double estimate_tolerance = 0.2;

/// The same of the peak bytes of a k-d build, whose small nodes leave more of their arrays unused.
inline constexpr double kd_peak_estimate_tolerance = 0.6;

/// Estimates the size and time of build_kd_tree() with these primitives and options. Builds a
/// sixteenth of the scene, in pieces spread over all of it; that takes about a fifth of the build
/// time. Everything but the seconds depends on primitives and options alone. The seconds hold for
/// this machine at this time, and for memory that the process has not touched yet. Throws as
/// build_kd_tree() does.
[[nodiscard]] COPPICE_EXPORT BuildEstimate estimate_kd_tree(PrimitiveSetView primitives,
                                                            const KdOptions& options = {},
                                                            const std::stop_token& stop = {});

/// Estimates the size and time of build_bvh8() in the same way. Takes up to half of the build time.
[[nodiscard]] COPPICE_EXPORT BuildEstimate estimate_bvh8(TriangleMeshView mesh,
                                                         const Bvh8Options& options = {},
                                                         const std::stop_token& stop = {});

}  // namespace coppice::inline v0
