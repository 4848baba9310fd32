#pragma once

#include "coppice/build/split_finder.h"

#include <optional>

namespace coppice {

/// The cheapest split of a node at any fragment end on one axis; the first of equal ones.
[[nodiscard]] std::optional<Split> sweep_axis(const SplitQuery& query, Axis axis);

}  // namespace coppice
