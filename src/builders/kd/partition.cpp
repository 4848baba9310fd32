// Divides a node's PrimRefs at a plane. Building, refilling and growing share this step, so that
// they agree on every primitive to the bit. A primitive across the plane is clipped to the part of
// its PrimRef's box on each side, not to the child's box. So PrimRefs only shrink on the way down,
// and two ways to the same leaf give the same PrimRef.
// Source: [WaldHavran2006] sec. 2.4 (perfect splits) and 4.2.

#include "builders/kd/partition.h"

#include "coppice/base/parallel.h"

#include "base/free_memory.h"
#include "builders/chunk_sizes.h"

#include <algorithm>
#include <cstddef>

namespace coppice::inline v0 {
namespace {

void divide_across(const PrimRef& prim_ref, SplitPlane plane, const Division& division,
                   PartitionOutput& out) {
    Aabb lower = below(prim_ref.box, plane);
    Aabb upper = above(prim_ref.box, plane);
    if (division.clipping == Clipping::perfect) {
        const Aabb clipped_lower = division.primitives.clipped_bounds(prim_ref.id, lower);
        const Aabb clipped_upper = division.primitives.clipped_bounds(prim_ref.id, upper);
        // If clipping finds no part on either side, the primitive stays on both sides, so that it
        // is not lost.
        if (!clipped_lower.is_empty() || !clipped_upper.is_empty()) {
            lower = clipped_lower;
            upper = clipped_upper;
        }
    }
    // Copied first: `prim_ref` may refer to *out.above.
    const std::uint32_t id = prim_ref.id;
    const float weight = prim_ref.weight;
    if (!lower.is_empty()) *out.below++ = {lower, id, weight};
    if (!upper.is_empty()) *out.above++ = {upper, id, weight};
}

// Concatenates one side of the chunks of a partition.
std::vector<PrimRef> joined(std::span<Partition> chunks, std::vector<PrimRef> Partition::*side) {
    std::vector<std::size_t> ends;
    std::size_t count = 0;
    for (const Partition& chunk : chunks) {
        ends.push_back(count += (chunk.*side).size());
    }
    std::vector<PrimRef> all(count);
    parallel_for_chunks(chunks.size(), 1, [&](std::size_t i, std::size_t) {
        std::vector<PrimRef>& part = chunks[i].*side;
        std::copy(part.begin(), part.end(),
                  all.begin() + static_cast<std::ptrdiff_t>(ends[i] - part.size()));
        free_memory(part);
    });
    return all;
}

Partition partition_alone(std::span<const PrimRef> prim_refs, SplitPlane plane,
                          PlanarSide planar_side, const Division& division) {
    Partition sides{
        std::vector<PrimRef>(prim_refs.size()), std::vector<PrimRef>(prim_refs.size()), {}, {}};
    const PartitionOutput begin{sides.below.data(), sides.above.data()};
    const PartitionOutput end = divide(prim_refs, plane, planar_side, division, begin);
    sides.below.resize(static_cast<std::size_t>(end.below - begin.below));
    sides.above.resize(static_cast<std::size_t>(end.above - begin.above));
    sides.below_bytes = {division.meter, sides.below};
    sides.above_bytes = {division.meter, sides.above};
    return sides;
}

}  // namespace

PartitionOutput divide(std::span<const PrimRef> prim_refs, SplitPlane plane, PlanarSide planar_side,
                       const Division& division, PartitionOutput out) {
    const PlaneRelation side_of_planars =
        planar_side == PlanarSide::below ? PlaneRelation::below : PlaneRelation::above;
    for (const PrimRef& prim_ref : prim_refs) {
        PlaneRelation relation = relation_to(prim_ref.box, plane);
        if (relation == PlaneRelation::in_plane) relation = side_of_planars;
        if (relation == PlaneRelation::below) {
            *out.below++ = prim_ref;
        } else if (relation == PlaneRelation::above) {
            *out.above++ = prim_ref;
        } else {
            divide_across(prim_ref, plane, division, out);
        }
    }
    return out;
}

Partition partition(std::span<const PrimRef> prim_refs, SplitPlane plane, PlanarSide planar_side,
                    const Division& division) {
    if (prim_refs.size() <= prim_refs_per_task) {
        return partition_alone(prim_refs, plane, planar_side, division);
    }
    std::vector<Partition> chunks((prim_refs.size() + prim_refs_per_task - 1) / prim_refs_per_task);
    parallel_for_chunks(
        prim_refs.size(), prim_refs_per_task, [&](std::size_t begin, std::size_t end) {
            chunks[begin / prim_refs_per_task] = partition_alone(
                prim_refs.subspan(begin, end - begin), plane, planar_side, division);
        });
    Partition sides;
    sides.below = joined(chunks, &Partition::below);
    sides.below_bytes = {division.meter, sides.below};
    for (Partition& chunk : chunks) {
        chunk.below_bytes.release();
    }
    sides.above = joined(chunks, &Partition::above);
    sides.above_bytes = {division.meter, sides.above};
    return sides;
}

std::vector<PrimRef> whole_prim_refs(PrimitiveSetView primitives) {
    std::vector<PrimRef> prim_refs(primitives.size());
    parallel_for_chunks(prim_refs.size(), primitives_per_task,
                        [&](std::size_t begin, std::size_t end) {
                            for (std::size_t i = begin; i < end; ++i) {
                                const auto id = static_cast<std::uint32_t>(i);
                                prim_refs[i] = {primitives.bounds(id), id};
                            }
                        });
    return prim_refs;
}

Aabb bounds_of_all(PrimitiveSetView primitives) {
    std::vector<Aabb> parts((primitives.size() + primitives_per_task - 1) / primitives_per_task);
    parallel_for_chunks(primitives.size(), primitives_per_task,
                        [&](std::size_t begin, std::size_t end) {
                            for (std::size_t id = begin; id < end; ++id) {
                                parts[begin / primitives_per_task].grow(
                                    primitives.bounds(static_cast<std::uint32_t>(id)));
                            }
                        });
    Aabb box;
    for (const Aabb& part : parts) {
        box.grow(part);
    }
    return box;
}

}  // namespace coppice::inline v0
