#pragma once

#include "coppice/builders/build_context.h"
#include "coppice/builders/kd_options.h"
#include "coppice/export.h"
#include "coppice/geom/primitive_set.h"
#include "coppice/tree/kd_tree.h"

namespace coppice::inline v0 {

/// Last stage: builds on in every leaf with all of its primitives, as `options.leaf_refinement`
/// says. LeafRefinement::none returns the tree as it is.
[[nodiscard]] COPPICE_EXPORT KdTree refine(KdTree&& tree, PrimitiveSetView primitives,
                                           const KdOptions& options,
                                           const BuildContext& context = {});

/// Goes on in every leaf by the split rule of the options until no split costs less than the leaf
/// or max_depth is reached; max_leaf and bad_refines do not apply. Planes that the sample chose
/// badly are retracted: those that cut off cells empty in the sample only, and those chosen from a
/// handful of sampled primitives. At sample rate 1 all planes stay.
[[nodiscard]] COPPICE_EXPORT KdTree grow_kd(KdTree&& tree, PrimitiveSetView primitives,
                                            const KdOptions& options,
                                            const BuildContext& context = {});

}  // namespace coppice::inline v0
