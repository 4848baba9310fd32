#pragma once

#include "coppice/base/memory_meter.h"
#include "coppice/builders/kd_options.h"
#include "coppice/builders/split_finder.h"
#include "coppice/geom/primitive_set.h"

#include <span>
#include <utility>
#include <vector>

namespace coppice::inline v0 {

/// The position of a PrimRef relative to a plane.
enum class PlaneRelation { below, above, across, in_plane };

/// Classifies a PrimRef. Split costs, building and refilling all use this rule. Touching is not
/// crossing: a PrimRef that ends at the plane is on one side.
[[nodiscard]] constexpr PlaneRelation relation_to(const Aabb& prim_ref, SplitPlane plane) noexcept {
    const float lower = prim_ref.lower[plane.axis];
    const float upper = prim_ref.upper[plane.axis];
    if (lower < plane.position) {
        return upper <= plane.position ? PlaneRelation::below : PlaneRelation::across;
    }
    return upper > plane.position || lower > plane.position ? PlaneRelation::above
                                                            : PlaneRelation::in_plane;
}

/// How PrimRefs are divided. The same for all nodes of a build.
struct Division {
    PrimitiveSetView primitives;
    Clipping clipping;
    MemoryMeter* meter = nullptr;  ///< counts the arrays that partition() makes
};

/// Output ranges for the PrimRefs of two children. Each must have room for all PrimRefs of the
/// parent.
struct PartitionOutput {
    PrimRef* below;
    PrimRef* above;
};

/// Divides a node's PrimRefs at a plane; both sides keep their order. A PrimRef across the plane
/// goes to every side that its primitive reaches, with its box clipped. None is lost. `out.above`
/// may be the beginning of the PrimRefs: that side is then divided in place. Returns the ends of
/// both sides.
PartitionOutput divide(std::span<const PrimRef> prim_refs, SplitPlane plane, PlanarSide planar_side,
                       const Division& division, PartitionOutput out);

/// The PrimRefs of a node's two children, in the order of the node's.
struct Partition {
    std::vector<PrimRef> below;
    std::vector<PrimRef> above;
    MeteredBytes below_bytes;
    MeteredBytes above_bytes;

    /// Moves the PrimRefs of a side out; the caller then counts their memory.
    [[nodiscard]] std::vector<PrimRef> take_below() noexcept {
        below_bytes.release();
        return std::move(below);
    }

    [[nodiscard]] std::vector<PrimRef> take_above() noexcept {
        above_bytes.release();
        return std::move(above);
    }
};

/// Divides PrimRefs into new arrays, in parallel if there are many. See divide().
[[nodiscard]] Partition partition(std::span<const PrimRef> prim_refs, SplitPlane plane,
                                  PlanarSide planar_side, const Division& division);

/// Makes the PrimRefs of all primitives, unclipped, in the order of their ids.
[[nodiscard]] std::vector<PrimRef> whole_prim_refs(PrimitiveSetView primitives);

/// The bounding box of all primitives.
[[nodiscard]] Aabb bounds_of_all(PrimitiveSetView primitives);

}  // namespace coppice::inline v0
