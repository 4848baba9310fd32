// Division of a node's fragments at a plane: the step that build, refill and growth share, so that
// they agree on every primitive bit for bit. A straddling primitive is clipped to the part of its
// fragment's box on each side, not to the child's box: fragments only ever shrink on the way down,
// and two ways to the same leaf give the same fragment.
// Source: [WaldHavran2006] sec. 2.4 (perfect splits) and 4.2.

#include "build/partition.h"

#include "coppice/base/parallel.h"

namespace coppice {
namespace {

void divide(const Fragment& fragment, Plane plane, PrimitiveSetView primitives, Clipping clipping,
            Partition& sides) {
    Aabb lower = below(fragment.box, plane);
    Aabb upper = above(fragment.box, plane);
    if (clipping == Clipping::perfect) {
        const Aabb clipped_lower = primitives.clipped_bounds(fragment.id, lower);
        const Aabb clipped_upper = primitives.clipped_bounds(fragment.id, upper);
        // A primitive that its own clipping denies on both sides stays on both: nothing is lost.
        if (!clipped_lower.is_empty() || !clipped_upper.is_empty()) {
            lower = clipped_lower;
            upper = clipped_upper;
        }
    }
    if (!lower.is_empty()) sides.below.push_back({lower, fragment.id, fragment.weight});
    if (!upper.is_empty()) sides.above.push_back({upper, fragment.id, fragment.weight});
}

}  // namespace

Partition partition(std::span<const Fragment> fragments, Plane plane, PlanarSide planar_side,
                    PrimitiveSetView primitives, Clipping clipping) {
    Partition sides;
    for (const Fragment& fragment : fragments) {
        PlaneRelation relation = relation_to(fragment.box, plane);
        if (relation == PlaneRelation::in_plane) {
            relation =
                planar_side == PlanarSide::below ? PlaneRelation::below : PlaneRelation::above;
        }
        if (relation == PlaneRelation::below) {
            sides.below.push_back(fragment);
        } else if (relation == PlaneRelation::above) {
            sides.above.push_back(fragment);
        } else {
            divide(fragment, plane, primitives, clipping, sides);
        }
    }
    return sides;
}

std::vector<Fragment> whole_fragments(PrimitiveSetView primitives) {
    constexpr std::size_t chunk_size = 16384;
    std::vector<Fragment> fragments(primitives.size());
    parallel_for_chunks(fragments.size(), chunk_size, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
            const auto id = static_cast<std::uint32_t>(i);
            fragments[i] = {primitives.bounds(id), id};
        }
    });
    return fragments;
}

Aabb bounds_of_all(PrimitiveSetView primitives) {
    Aabb box;
    for (std::uint32_t id = 0; id < primitives.size(); ++id)
        box.grow(primitives.bounds(id));
    return box;
}

}  // namespace coppice
