// Division of a node's fragments at a plane: the step that build, refill and growth share, so that
// they agree on every primitive bit for bit. A straddling primitive is clipped to the part of its
// fragment's box on each side, not to the child's box: fragments only ever shrink on the way down,
// and two ways to the same leaf give the same fragment.
// Source: [WaldHavran2006] sec. 2.4 (perfect splits) and 4.2.

#include "build/partition.h"

#include "coppice/base/parallel.h"

#include "base/free_memory.h"

#include <algorithm>
#include <cstddef>

namespace coppice {
namespace {

void divide_across(const Fragment& fragment, Plane plane, const Division& division,
                   PartitionOutput& out) {
    Aabb lower = below(fragment.box, plane);
    Aabb upper = above(fragment.box, plane);
    if (division.clipping == Clipping::perfect) {
        const Aabb clipped_lower = division.primitives.clipped_bounds(fragment.id, lower);
        const Aabb clipped_upper = division.primitives.clipped_bounds(fragment.id, upper);
        // A primitive that its own clipping denies on both sides stays on both: nothing is lost.
        if (!clipped_lower.is_empty() || !clipped_upper.is_empty()) {
            lower = clipped_lower;
            upper = clipped_upper;
        }
    }
    // `fragment` may be where *out.above is.
    const std::uint32_t id = fragment.id;
    const float weight = fragment.weight;
    if (!lower.is_empty()) *out.below++ = {lower, id, weight};
    if (!upper.is_empty()) *out.above++ = {upper, id, weight};
}

// One side of a partition made in chunks.
std::vector<Fragment> joined(std::span<Partition> chunks, std::vector<Fragment> Partition::*side) {
    std::vector<std::size_t> ends;
    std::size_t count = 0;
    for (const Partition& chunk : chunks) {
        ends.push_back(count += (chunk.*side).size());
    }
    std::vector<Fragment> all(count);
    parallel_for_chunks(chunks.size(), 1, [&](std::size_t i, std::size_t) {
        std::vector<Fragment>& part = chunks[i].*side;
        std::copy(part.begin(), part.end(),
                  all.begin() + static_cast<std::ptrdiff_t>(ends[i] - part.size()));
        free_memory(part);
    });
    return all;
}

Partition partition_alone(std::span<const Fragment> fragments, Plane plane, PlanarSide planar_side,
                          const Division& division) {
    Partition sides{
        std::vector<Fragment>(fragments.size()), std::vector<Fragment>(fragments.size()), {}, {}};
    const PartitionOutput begin{sides.below.data(), sides.above.data()};
    const PartitionOutput end = divide(fragments, plane, planar_side, division, begin);
    sides.below.resize(static_cast<std::size_t>(end.below - begin.below));
    sides.above.resize(static_cast<std::size_t>(end.above - begin.above));
    sides.below_bytes = {division.meter, sides.below};
    sides.above_bytes = {division.meter, sides.above};
    return sides;
}

}  // namespace

PartitionOutput divide(std::span<const Fragment> fragments, Plane plane, PlanarSide planar_side,
                       const Division& division, PartitionOutput out) {
    const PlaneRelation side_of_planars =
        planar_side == PlanarSide::below ? PlaneRelation::below : PlaneRelation::above;
    for (const Fragment& fragment : fragments) {
        PlaneRelation relation = relation_to(fragment.box, plane);
        if (relation == PlaneRelation::in_plane) relation = side_of_planars;
        if (relation == PlaneRelation::below) {
            *out.below++ = fragment;
        } else if (relation == PlaneRelation::above) {
            *out.above++ = fragment;
        } else {
            divide_across(fragment, plane, division, out);
        }
    }
    return out;
}

Partition partition(std::span<const Fragment> fragments, Plane plane, PlanarSide planar_side,
                    const Division& division) {
    constexpr std::size_t chunk_size = 32768;
    if (fragments.size() <= chunk_size) {
        return partition_alone(fragments, plane, planar_side, division);
    }
    std::vector<Partition> chunks((fragments.size() + chunk_size - 1) / chunk_size);
    parallel_for_chunks(fragments.size(), chunk_size, [&](std::size_t begin, std::size_t end) {
        chunks[begin / chunk_size] =
            partition_alone(fragments.subspan(begin, end - begin), plane, planar_side, division);
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
    constexpr std::size_t chunk_size = 16384;
    std::vector<Aabb> parts((primitives.size() + chunk_size - 1) / chunk_size);
    parallel_for_chunks(primitives.size(), chunk_size, [&](std::size_t begin, std::size_t end) {
        for (std::size_t id = begin; id < end; ++id) {
            parts[begin / chunk_size].grow(primitives.bounds(static_cast<std::uint32_t>(id)));
        }
    });
    Aabb box;
    for (const Aabb& part : parts) {
        box.grow(part);
    }
    return box;
}

}  // namespace coppice
