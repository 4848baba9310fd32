#pragma once

#include "coppice/base/memory_meter.h"
#include "coppice/builders/build_options.h"
#include "coppice/builders/progress.h"
#include "coppice/geom/primitive_set.h"
#include "coppice/sample/sampler.h"
#include "coppice/tree/kd_tree.h"

namespace coppice::inline v0 {

/// Second stage: a k-d tree over the sampled primitives, top-down. Its box is that of *all*
/// primitives, so that the others fit in later. Deterministic for any number of threads.
/// `meter`, if given, is told of its arrays, and `progress` of what is done, here and in the other
/// stages.
/// Source: [Tsiompikas2022] sec. 4.3.1, [Pharr2016] sec. 4.4.
[[nodiscard]] KdTree build_on_sample(PrimitiveSetView primitives, const Sample& sample,
                                     const BuildOptions& options, MemoryMeter* meter = nullptr,
                                     Progress* progress = nullptr);

}  // namespace coppice::inline v0
