#pragma once

#include "coppice/build/build_options.h"
#include "coppice/build/split_finder.h"
#include "coppice/geom/primitive_set.h"

#include <span>
#include <vector>

namespace coppice {

/// Where a fragment lies with respect to a plane.
enum class PlaneRelation { below, above, across, in_plane };

/// The one classification that split costs, build and refill share. Touching is not crossing: a
/// fragment that ends at the plane is on one side.
[[nodiscard]] constexpr PlaneRelation relation_to(const Aabb& fragment, Plane plane) noexcept {
    const float lower = fragment.lower[plane.axis];
    const float upper = fragment.upper[plane.axis];
    if (lower < plane.position) {
        return upper <= plane.position ? PlaneRelation::below : PlaneRelation::across;
    }
    return upper > plane.position || lower > plane.position ? PlaneRelation::above
                                                            : PlaneRelation::in_plane;
}

/// The fragments of a node's two children, each in the order of the node's.
struct Partition {
    std::vector<Fragment> below;
    std::vector<Fragment> above;
};

/// Divides a node's fragments at a plane. A fragment across it goes to every side that its
/// primitive reaches, clipped anew; none is lost.
[[nodiscard]] Partition partition(std::span<const Fragment> fragments, Plane plane,
                                  PlanarSide planar_side, PrimitiveSetView primitives,
                                  Clipping clipping);

/// The fragments of all primitives, unclipped, in the order of their ids.
[[nodiscard]] std::vector<Fragment> whole_fragments(PrimitiveSetView primitives);

/// The box of all primitives.
[[nodiscard]] Aabb bounds_of_all(PrimitiveSetView primitives);

}  // namespace coppice
