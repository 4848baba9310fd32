#pragma once

#include "coppice/builders/split_finder.h"

#include <optional>

namespace coppice::inline v0 {

/// The cheapest split of a node at any PrimRef end on one axis; the first of equal ones.
[[nodiscard]] std::optional<SplitCandidate> sweep_axis(const SplitQuery& query, Axis axis);

/// The cheapest split of a node at any PrimRef end on any axis; of equal ones the first by axis,
/// then by position. O(n log n).
[[nodiscard]] std::optional<SplitCandidate> sweep_all_axes(const SplitQuery& query);

}  // namespace coppice::inline v0
