#pragma once

#include "coppice/builders/split_finder.h"

#include "builders/kernels/plane_costs.h"

#include <cstddef>
#include <optional>

namespace coppice::inline v0 {

/// The greatest number of PrimRefs of a small node.
inline constexpr std::size_t small_node_size = small_node_capacity;

/// The cheapest split of a small node at any PrimRef end on any axis; of equal ones the first by
/// axis, then by position. Equals the split that ExactSplit finds.
[[nodiscard]] std::optional<SplitCandidate> find_in_small_node(const SplitQuery& query);

}  // namespace coppice::inline v0
