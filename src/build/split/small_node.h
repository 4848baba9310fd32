#pragma once

#include "coppice/build/split_finder.h"

#include "build/kernels/plane_costs.h"

#include <cstddef>
#include <optional>

namespace coppice {

/// Nodes of at most so many fragments are small.
inline constexpr std::size_t small_node_size = small_node_capacity;

/// The cheapest split of a small node at any fragment end on any axis; of equal ones the first by
/// axis, then by position: what ExactSplit finds in any node.
[[nodiscard]] std::optional<Split> find_in_small_node(const SplitQuery& query) noexcept;

}  // namespace coppice
