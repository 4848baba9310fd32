#pragma once

#include "coppice/base/memory_meter.h"
#include "coppice/build/build_options.h"
#include "coppice/build/split_finder.h"
#include "coppice/geom/primitive_set.h"

#include <span>
#include <utility>
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

/// How fragments are divided: the same for all nodes of a build.
struct Division {
    PrimitiveSetView primitives;
    Clipping clipping;
    MemoryMeter* meter = nullptr;  ///< told of the arrays that partition() makes
};

/// Room for the fragments of two children; each takes at most as many as their parent has.
struct PartitionOutput {
    Fragment* below;
    Fragment* above;
};

/// Divides a node's fragments at a plane, both sides in the order of the node's. A fragment across
/// it goes to every side that its primitive reaches, clipped anew; none is lost. `out.above` may be
/// where the fragments are: that side is then divided in place. Returns the ends of both sides.
PartitionOutput divide(std::span<const Fragment> fragments, Plane plane, PlanarSide planar_side,
                       const Division& division, PartitionOutput out);

/// The fragments of a node's two children, each in the order of the node's.
struct Partition {
    std::vector<Fragment> below;
    std::vector<Fragment> above;
    MeteredBytes below_bytes;
    MeteredBytes above_bytes;

    /// Hands the fragments of a side over to one who counts them.
    [[nodiscard]] std::vector<Fragment> take_below() noexcept {
        below_bytes.release();
        return std::move(below);
    }

    [[nodiscard]] std::vector<Fragment> take_above() noexcept {
        above_bytes.release();
        return std::move(above);
    }
};

/// divide() into new arrays, in parallel where there are many fragments.
[[nodiscard]] Partition partition(std::span<const Fragment> fragments, Plane plane,
                                  PlanarSide planar_side, const Division& division);

/// The fragments of all primitives, unclipped, in the order of their ids.
[[nodiscard]] std::vector<Fragment> whole_fragments(PrimitiveSetView primitives);

/// The box of all primitives.
[[nodiscard]] Aabb bounds_of_all(PrimitiveSetView primitives);

}  // namespace coppice
