#pragma once

#include "build/exact/classify.h"
#include "build/exact/exact_node.h"

namespace coppice {

/// The children of a divided node, in order.
struct ExactChildren {
    ExactNode below;
    ExactNode above;
};

/// The children with their sorted events: those of their parent, less those of clipped fragments,
/// which get new ones. Frees the parent's arrays.
[[nodiscard]] ExactChildren splice(ExactNode&& node, const Classification& classification,
                                   Partition&& sides);

}  // namespace coppice
