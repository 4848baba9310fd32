#pragma once

#include "coppice/builders/build_context.h"
#include "coppice/builders/kd_options.h"
#include "coppice/export.h"
#include "coppice/geom/primitive_set.h"
#include "coppice/tree/kd_tree.h"

namespace coppice::inline v0 {

/// Fourth stage: puts every primitive into every leaf that it touches (a point into the leaf that
/// contains it). Uses the builder's own rules, so that refilling a skeleton built from all
/// primitives restores the builder's leaves. No primitive is lost. The skeleton's box must contain
/// all primitives. Throws Error(limit) if there would be more than 2^32 - 1 references.
/// Source: [Tsiompikas2022] sec. 4.3.3.
[[nodiscard]] COPPICE_EXPORT KdTree refill(Skeleton&& skeleton, PrimitiveSetView primitives,
                                           const KdOptions& options,
                                           const BuildContext& context = {});

}  // namespace coppice::inline v0
