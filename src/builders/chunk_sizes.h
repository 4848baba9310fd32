#pragma once

#include <cstddef>

namespace coppice::inline v0 {

// The sizes of tasks in parallel passes: large enough to outweigh the cost of a task, small enough
// to balance the load. Results do not depend on them.

/// Primitives per task where boxes are computed.
inline constexpr std::size_t primitives_per_task = 16384;

/// PrimRefs per task where they are counted or copied, which is faster.
inline constexpr std::size_t prim_refs_per_task = 32768;

/// Levels that PrimRefs descend in one pass. With more, the lists of the cells no longer fit in the
/// cache; with fewer, there are more copies.
inline constexpr int levels_at_once = 10;

}  // namespace coppice::inline v0
