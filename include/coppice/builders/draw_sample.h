#pragma once

#include "coppice/export.h"
#include "coppice/geom/primitive_set.h"
#include "coppice/sample/sampler.h"

namespace coppice::inline v0 {

/// First stage: chooses the primitives to build from, by the sampler that the options name
/// or bring. Rate 1 gives all of them. Throws Error(invalid_argument) for an unknown sampler, a
/// rate outside (0, 1], and a custom sampler that does not keep its contract.
[[nodiscard]] COPPICE_EXPORT Sample draw_sample(PrimitiveSetView primitives,
                                                const SampleOptions& options);

}  // namespace coppice::inline v0
