#pragma once

#include "coppice/builders/split_finder.h"

#include "builders/kd/exact/exact_node.h"

#include <optional>

namespace coppice::inline v0 {

/// The cheapest split of a node at any event on any axis; of equal ones the first by axis, then by
/// position. Equals the split of ExactSplit. `weight` is the sum of the PrimRefs' weights.
[[nodiscard]] std::optional<SplitCandidate> sweep(const ExactNode& node, const Aabb& box,
                                                  double weight, const SahCostModel& cost);

}  // namespace coppice::inline v0
