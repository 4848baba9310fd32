// Which side of the plane each fragment is on, so that its events need not be classified one by
// one. Cost: O(n), and the clipping of those across. Source: [WaldHavran2006] sec. 4.3, step 1.

#include "build/exact/classify.h"

#include "build/stop_look.h"

#include <span>

namespace coppice {

namespace {

// How many fragments each side has at most, so that large nodes do not take room for all twice.
struct SideLimits {
    std::size_t below = 0;
    std::size_t above = 0;
};

SideLimits limits_of(std::span<const Fragment> fragments, Plane plane, PlanarSide planar_side) {
    SideLimits limits;
    for (const Fragment& fragment : fragments) {
        const PlaneRelation relation = relation_to(fragment.box, plane);
        const bool is_in_plane = relation == PlaneRelation::in_plane;
        const bool is_planar_below = is_in_plane && planar_side == PlanarSide::below;
        const bool is_planar_above = is_in_plane && planar_side == PlanarSide::above;
        limits.below += relation != PlaneRelation::above && !is_planar_above ? 1U : 0U;
        limits.above += relation != PlaneRelation::below && !is_planar_below ? 1U : 0U;
    }
    return limits;
}

}  // namespace

Classification classify(const ExactNode& node, Plane plane, PlanarSide planar_side,
                        const Division& division, Partition& sides) {
    const std::size_t count = node.fragments.size();
    Classification result;
    result.moved_to.resize(count);
    const SideLimits limits = limits_of(node.fragments, plane, planar_side);
    sides.below.resize(limits.below);
    sides.above.resize(limits.above);
    const PartitionOutput begin{sides.below.data(), sides.above.data()};
    PartitionOutput end = begin;
    StopLook look;
    for (std::size_t slot = 0; slot < count; ++slot) {
        look.at(slot);
        const Fragment& fragment = node.fragments[slot];
        const PartitionOutput before = end;
        end = divide(std::span(&fragment, 1), plane, planar_side, division, end);
        const auto below_slot = static_cast<std::uint32_t>(before.below - begin.below);
        const auto above_slot = static_cast<std::uint32_t>(before.above - begin.above);
        if (relation_to(fragment.box, plane) == PlaneRelation::across) {
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

}  // namespace coppice
