#pragma once

#include "coppice/build/split_finder.h"

#include "build/exact/exact_node.h"

#include <optional>

namespace coppice {

/// The cheapest split of a node at any event on any axis; of equal ones the first by axis, then by
/// position: what ExactSplit finds. `weight`: of its fragments.
[[nodiscard]] std::optional<Split> sweep(const ExactNode& node, const Aabb& box, double weight,
                                         const SahCostModel& cost);

}  // namespace coppice
