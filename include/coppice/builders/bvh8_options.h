#pragma once

#include "coppice/cost/sah_cost_model.h"
#include "coppice/export.h"
#include "coppice/sample/sampler.h"

#include <cstdint>

namespace coppice::inline v0 {

/// How much an 8-wide tree may cost to build.
enum class Bvh8Preset {
    automatic,  ///< fast, or quality where 30 rays and more are expected for a triangle; at a
                ///< sample rate of 1 fast takes its own sample: 1 %, weighted
    fast,       ///< least build time: cells by centroids, nothing is cut
    balanced,   ///< cells by planes, which cut the triangles between them: better for large ones
    quality     ///< spatial splits throughout, at most 1.1 references a triangle: for many rays
};

/// All that build_bvh8() depends on, beside the mesh.
struct Bvh8Options {
    SampleOptions sample;                       ///< of scenes of `sampled_from` triangles and more
    Bvh8Preset preset = Bvh8Preset::automatic;  ///< how much the build may cost
    double expected_rays = 1e7;            ///< that will be traced: what `automatic` goes by; >= 0
    std::uint32_t cell_size = 0;           ///< triangles a cell is to hold, >= 64; 0: the preset's
    std::uint32_t sampled_from = 200'000;  ///< scenes of fewer triangles are not sampled
    SahCostModel cost;  ///< what the tree is measured by; splits have constants of their own
    int threads = 0;    ///< at most so many; 0 = all the hardware has
};

/// Throws Error(invalid_argument) naming the first option outside its range.
COPPICE_EXPORT void require_valid(const Bvh8Options& options);

/// The stable lower-case name, e.g. "automatic".
[[nodiscard]] COPPICE_EXPORT const char* name_of(Bvh8Preset preset) noexcept;

}  // namespace coppice::inline v0
