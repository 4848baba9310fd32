#pragma once

#include "builders/kd/exact/exact_node.h"
#include "builders/kd/partition.h"

#include <cstdint>
#include <vector>

namespace coppice::inline v0 {

/// The sides that the PrimRefs of a node were assigned to.
struct Classification {
    /// Indexed by slot. For a PrimRef on one side: its new slot, plus in_upper_child if it is
    /// above. For one across the plane: moved_anew.
    std::vector<std::uint32_t> moved_to;

    /// The new slots of PrimRefs across the plane, whose boxes have changed.
    std::vector<std::uint32_t> clipped_below;
    std::vector<std::uint32_t> clipped_above;

    static constexpr std::uint32_t in_upper_child = 1U << 31;
    static constexpr std::uint32_t moved_anew = ~0U;
};

/// Divides a node's PrimRefs at a plane, exactly as divide() does. splice() then divides the
/// events.
[[nodiscard]] Classification classify(const ExactNode& node, SplitPlane plane,
                                      PlanarSide planar_side, const Division& division,
                                      Partition& sides);

}  // namespace coppice::inline v0
