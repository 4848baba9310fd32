#pragma once

#include "coppice/export.h"
#include "coppice/geom/primitive_set.h"
#include "coppice/sample/sampler.h"

namespace coppice::inline v0 {

/// First stage: draws the primitives to build from, with the sampler that the options name or
/// contain. A rate of 1 selects all of them. Throws Error(invalid_argument) for an unknown sampler,
/// a rate outside (0, 1], and a custom sampler that violates its contract.
[[nodiscard]] COPPICE_EXPORT Sample draw_sample(PrimitiveSetView primitives,
                                                const SampleOptions& options);

}  // namespace coppice::inline v0
