#pragma once

#include "coppice/tree/bvh8.h"
#include "coppice/tree/kd_tree.h"

#include <cstdint>
#include <string>

namespace coppice::inline v0 {

/// What could lead a query out of a tree's arrays, into a loop, or to a primitive that does not
/// exist, in words; "" if nothing can. Takes one pass over the arrays; does not look at planes,
/// boxes of children and corners, which decide what is found and not whether that is safe.
[[nodiscard]] std::string find_flaw(const KdTree& tree, std::uint32_t primitive_count);
[[nodiscard]] std::string find_flaw(const Bvh8& tree, std::uint32_t primitive_count);

}  // namespace coppice::inline v0
