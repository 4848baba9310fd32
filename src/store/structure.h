#pragma once

#include "coppice/tree/bvh8.h"
#include "coppice/tree/kd_tree.h"

#include <cstdint>
#include <string>

namespace coppice::inline v0 {

/// Describes the first fault that could lead a query out of a tree's arrays, into a loop, or to a
/// primitive that does not exist; "" if there is none. One pass over the arrays. Planes, child
/// boxes and corners are not checked: they affect what a query finds, but not its safety.
[[nodiscard]] std::string find_flaw(const KdTree& tree, std::uint32_t primitive_count);
[[nodiscard]] std::string find_flaw(const Bvh8& tree, std::uint32_t primitive_count);

}  // namespace coppice::inline v0
