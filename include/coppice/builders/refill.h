#pragma once

#include "coppice/builders/build_context.h"
#include "coppice/builders/kd_options.h"
#include "coppice/export.h"
#include "coppice/geom/primitive_set.h"
#include "coppice/tree/kd_tree.h"

namespace coppice::inline v0 {

/// Fourth stage: every primitive goes down to every leaf that it touches (a point to the one that
/// holds it), by the very rules of the builder: on a skeleton built from all primitives it gives
/// back the builder's leaves. No primitive is lost. The skeleton's box must hold all primitives.
/// Throws Error(limit) if there would be more than 2^32 - 1 references.
/// Source: [Tsiompikas2022] sec. 4.3.3.
[[nodiscard]] COPPICE_EXPORT KdTree refill(Skeleton&& skeleton, PrimitiveSetView primitives,
                                           const KdOptions& options,
                                           const BuildContext& context = {});

}  // namespace coppice::inline v0
