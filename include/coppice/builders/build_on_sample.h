#pragma once

#include "coppice/builders/build_context.h"
#include "coppice/builders/kd_options.h"
#include "coppice/export.h"
#include "coppice/geom/primitive_set.h"
#include "coppice/sample/sampler.h"
#include "coppice/tree/kd_tree.h"

namespace coppice::inline v0 {

/// Second stage: builds a k-d tree over the sampled primitives, top-down. Its box is that of *all*
/// primitives, so that the others fit in later. Deterministic for any number of threads. Stages do
/// not check the primitives; build_kd_tree() does before it calls them.
/// Source: [Tsiompikas2022] sec. 4.3.1, [Pharr2016] sec. 4.4.
[[nodiscard]] COPPICE_EXPORT KdTree build_on_sample(PrimitiveSetView primitives,
                                                    const Sample& sample, const KdOptions& options,
                                                    const BuildContext& context = {});

}  // namespace coppice::inline v0
