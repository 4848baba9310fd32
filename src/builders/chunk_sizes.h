#pragma once

#include <cstddef>

namespace coppice::inline v0 {

// How much one task of a pass works on: enough to make up for handing it over, few enough to share
// out evenly. Results do not depend on it.

/// Primitives whose boxes are looked at.
inline constexpr std::size_t primitives_per_task = 16384;

/// PrimRefs that are counted or copied, which is done sooner.
inline constexpr std::size_t prim_refs_per_task = 32768;

/// Levels that PrimRefs go down at once: with more, the lists of the cells become too many for the
/// cache; with fewer, there are more copies.
inline constexpr int levels_at_once = 10;

}  // namespace coppice::inline v0
