#pragma once

#include "builders/kd/exact/classify.h"
#include "builders/kd/exact/exact_node.h"

namespace coppice::inline v0 {

/// The children of a divided node, the lower one first.
struct ExactChildren {
    ExactNode below;
    ExactNode above;
};

/// Makes the children with their sorted events: those of the parent, with new ones for clipped
/// PrimRefs. Frees the parent's arrays.
[[nodiscard]] ExactChildren splice(ExactNode&& node, const Classification& classification,
                                   Partition&& sides);

}  // namespace coppice::inline v0
