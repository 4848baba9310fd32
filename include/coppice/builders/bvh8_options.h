#pragma once

#include "coppice/cost/sah_cost_model.h"
#include "coppice/export.h"
#include "coppice/sample/sampler.h"

#include <cstdint>

namespace coppice::inline v0 {

/// The trade-off between build time and tracing speed of an 8-wide tree.
enum class Bvh8Preset {
    automatic,  ///< quality if at least 30 rays per triangle are expected, else fast; at
                ///< sample rate 1, fast draws its own sample: 1 %, weighted
    fast,       ///< least build time: cells by centroids, no triangle is cut
    balanced,   ///< cells by planes that cut triangles: better for large triangles
    quality     ///< spatial splits, at most 1.1 references a triangle: for many rays
};

/// All options of build_bvh8().
struct Bvh8Options {
    SampleOptions sample;                       ///< for scenes of at least `sampled_from` triangles
    Bvh8Preset preset = Bvh8Preset::automatic;  ///< trade-off of build time and tracing speed
    double expected_rays = 1e7;                 ///< rays to be traced, for `automatic`; >= 0
    std::uint32_t cell_size = 0;           ///< target triangles per cell, >= 64; 0: the preset's
    std::uint32_t sampled_from = 200'000;  ///< scenes of fewer triangles are not sampled
    SahCostModel cost;  ///< for measuring the tree; splits use fixed cost constants
    int threads = 0;    ///< greatest number of threads; 0 = all hardware threads
};

/// Throws Error(invalid_argument) naming the first option outside its range.
COPPICE_EXPORT void require_valid(const Bvh8Options& options);

/// The stable lower-case name, e.g. "automatic".
[[nodiscard]] COPPICE_EXPORT const char* name_of(Bvh8Preset preset) noexcept;

}  // namespace coppice::inline v0
