// Determines the side of the plane for each PrimRef, so that its events need not be classified one
// by one. Cost: O(n), plus the clipping of PrimRefs across the plane.
// Source: [WaldHavran2006] sec. 4.3, step 1.

#include "builders/kd/exact/classify.h"

#include "base/cancellation_poll.h"

#include <span>

namespace coppice::inline v0 {

namespace {

// Upper limits of the PrimRefs on each side, so that large nodes do not allocate room for all of
// them twice.
struct SideLimits {
    std::size_t below = 0;
    std::size_t above = 0;
};

SideLimits limits_of(std::span<const PrimRef> prim_refs, SplitPlane plane, PlanarSide planar_side) {
    SideLimits limits;
    for (const PrimRef& prim_ref : prim_refs) {
        const PlaneRelation relation = relation_to(prim_ref.box, plane);
        const bool is_in_plane = relation == PlaneRelation::in_plane;
        const bool is_planar_below = is_in_plane && planar_side == PlanarSide::below;
        const bool is_planar_above = is_in_plane && planar_side == PlanarSide::above;
        limits.below += relation != PlaneRelation::above && !is_planar_above ? 1U : 0U;
        limits.above += relation != PlaneRelation::below && !is_planar_below ? 1U : 0U;
    }
    return limits;
}

}  // namespace

Classification classify(const ExactNode& node, SplitPlane plane, PlanarSide planar_side,
                        const Division& division, Partition& sides) {
    const std::size_t count = node.prim_refs.size();
    Classification result;
    result.moved_to.resize(count);
    const SideLimits limits = limits_of(node.prim_refs, plane, planar_side);
    sides.below.resize(limits.below);
    sides.above.resize(limits.above);
    const PartitionOutput begin{sides.below.data(), sides.above.data()};
    PartitionOutput end = begin;
    CancellationPoll look;
    for (std::size_t slot = 0; slot < count; ++slot) {
        look.at(slot);
        const PrimRef& prim_ref = node.prim_refs[slot];
        const PartitionOutput before = end;
        end = divide(std::span(&prim_ref, 1), plane, planar_side, division, end);
        const auto below_slot = static_cast<std::uint32_t>(before.below - begin.below);
        const auto above_slot = static_cast<std::uint32_t>(before.above - begin.above);
        if (relation_to(prim_ref.box, plane) == PlaneRelation::across) {
            result.moved_to[slot] = Classification::moved_anew;
            if (end.below != before.below) result.clipped_below.push_back(below_slot);
            if (end.above != before.above) result.clipped_above.push_back(above_slot);
        } else {
            result.moved_to[slot] = end.below != before.below
                                        ? below_slot
                                        : above_slot | Classification::in_upper_child;
        }
    }
    sides.below.resize(static_cast<std::size_t>(end.below - begin.below));
    sides.above.resize(static_cast<std::size_t>(end.above - begin.above));
    return result;
}

}  // namespace coppice::inline v0
