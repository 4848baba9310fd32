#pragma once

#include "builders/kd/exact/classify.h"
#include "builders/kd/exact/exact_node.h"

namespace coppice::inline v0 {

/// The children of a divided node, in order.
struct ExactChildren {
    ExactNode below;
    ExactNode above;
};

/// The children with their sorted events: those of their parent, less those of clipped PrimRefs,
/// which get new ones. Frees the parent's arrays.
[[nodiscard]] ExactChildren splice(ExactNode&& node, const Classification& classification,
                                   Partition&& sides);

}  // namespace coppice::inline v0
