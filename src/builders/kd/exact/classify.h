#pragma once

#include "builders/kd/exact/exact_node.h"
#include "builders/kd/partition.h"

#include <cstdint>
#include <vector>

namespace coppice::inline v0 {

/// Where the PrimRefs of a node have gone.
struct Classification {
    /// By slot: where a PrimRef that is not across the plane went: its new slot, plus
    /// in_upper_child if it is above; moved_anew if it is across.
    std::vector<std::uint32_t> moved_to;

    /// The new slots of PrimRefs that are across: their boxes have changed.
    std::vector<std::uint32_t> clipped_below;
    std::vector<std::uint32_t> clipped_above;

    static constexpr std::uint32_t in_upper_child = 1U << 31;
    static constexpr std::uint32_t moved_anew = ~0U;
};

/// Divides a node's PrimRefs at a plane, just as divide() does; events are left to splice().
[[nodiscard]] Classification classify(const ExactNode& node, SplitPlane plane,
                                      PlanarSide planar_side, const Division& division,
                                      Partition& sides);

}  // namespace coppice::inline v0
