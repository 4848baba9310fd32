// The inner loops of the 8-wide builder that divide PrimRefs by planes, on eight lanes. They clip
// triangles at planes. The lanes of a point are its negated coordinates and its coordinates, so
// that one maximum extends a box by it.
// Source: [Stich2009] sec. 4.2.

#include "simd/set.h"

#if defined(COPPICE_BUILDERS_KERNELS_SPATIAL_KERNELS_H) == defined(COPPICE_SIMD_TOGGLE)
#ifdef COPPICE_SIMD_TOGGLE
#undef COPPICE_BUILDERS_KERNELS_SPATIAL_KERNELS_H
#else
#define COPPICE_BUILDERS_KERNELS_SPATIAL_KERNELS_H
#endif

#include "builders/kernels/boxes.h"
#include "builders/kernels/bvh8_kernels.h"
#include "builders/kernels/slabs.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>

#include COPPICE_SIMD_LANES

COPPICE_SIMD_BEGIN

namespace coppice::inline v0::bvh8 {
namespace {
namespace COPPICE_SIMD_SET {

using namespace simd::COPPICE_SIMD_SET;

struct Corner {
    const Vec3f* point;
    Lanes lanes;
};

// A triangle's corners, and an upper bound of the rounding error of a point interpolated between
// two of them.
struct CutTriangle {
    explicit CutTriangle(const MeshArrays& mesh, std::uint32_t id) noexcept {
        for (std::size_t at = 0; at < 3; ++at) {
            const Vec3f& point = mesh.vertices[mesh.triangles[id][at]];
            corner[at] = {&point, lanes_of(point)};
        }
        const Lanes box = max(corner[0].lanes, max(corner[1].lanes, corner[2].lanes));
        const Lanes opposite = swap_halves(box);
        slack = (box + opposite) * broadcast(0x1.0p-20F) +
                max(box, opposite) * broadcast(0x1.0p-22F) + broadcast(0x1.0p-126F);
    }

    std::array<Corner, 3> corner;
    Lanes slack;
};

// The corners sorted by their position on an axis.
struct CornersAlong {
    CornersAlong(const CutTriangle& triangle, std::size_t axis) noexcept {
        for (std::size_t at = 0; at < 3; ++at) {
            place[at] = (&triangle.corner[at].point->x)[axis];
        }
        const auto order = [&](std::size_t a, std::size_t b) {
            if (!(place[b] < place[a])) return;
            std::swap(place[a], place[b]);
            std::swap(index[a], index[b]);
        };
        order(0, 1);
        order(1, 2);
        order(0, 1);
    }

    std::array<float, 3> place;
    std::array<std::size_t, 3> index{0, 1, 2};
};

// The parts of a box on both sides of a plane.
struct Parts {
    Lanes lower;
    Lanes upper;
};

inline Lanes between(Lanes from, Lanes to, float share) noexcept {
    return from + (to - from) * broadcast(share);
}

inline Lanes or_empty(Lanes box) noexcept {
    return has_extent(box) ? box : load_box(empty_box);
}

// The boxes of a triangle's parts on both sides of a plane, within `box`; empty if there is no
// part.
inline Parts cut(Lanes box, const CutTriangle& triangle, const CornersAlong& along,
                 CutPlane plane) noexcept {
    const auto [first, middle, last] = along.place;
    const float place = plane.position;
    if (place <= first) return {load_box(empty_box), box};
    if (place >= last) return {box, load_box(empty_box)};
    const Lanes a = triangle.corner[along.index[0]].lanes;
    const Lanes b = triangle.corner[along.index[1]].lanes;
    const Lanes c = triangle.corner[along.index[2]].lanes;
    const Lanes on_long_edge = between(a, c, (place - first) / (last - first));
    const Lanes on_short_edge = place < middle ? between(a, b, (place - first) / (middle - first))
                                               : between(b, c, (place - middle) / (last - middle));
    const Lanes crossing = max(on_long_edge, on_short_edge) + triangle.slack;
    const Lanes lower = max(max(a, crossing), middle <= place ? b : a);
    const Lanes upper = max(max(c, crossing), middle >= place ? b : c);
    const Lanes below = with_lane(box, 4 + plane.axis, place);
    const Lanes above = with_lane(box, plane.axis, -place);
    return {or_empty(min(lower, min(below, box))), or_empty(min(upper, min(above, box)))};
}

inline void add_pieces(Lanes box, const CutTriangle& triangle, const Slabs& slabs, std::size_t axis,
                       Sides<std::size_t> slab, SlabContents& contents) noexcept {
    const CornersAlong along(triangle, axis);
    for (std::size_t at = slab.lower; at < slab.upper; ++at) {
        const Parts parts = cut(box, triangle, along, slabs.below(axis, at + 1));
        grow(contents.box[at], parts.lower);
        box = parts.upper;
    }
    grow(contents.box[slab.upper], box);
}

void bin_pieces(std::span<const PrimRef> prim_refs, std::size_t stride, const MeshArrays& mesh,
                const Slabs& slabs, std::array<SlabContents, 3>& contents) noexcept {
    for (std::size_t next = 0; next < prim_refs.size(); next += stride) {
        const PrimRef& prim_ref = prim_refs[next];
        const Lanes box = lanes_of(prim_ref);
        std::array<Sides<std::size_t>, 3> slab;
        bool is_cut = false;
        for (std::size_t axis = 0; axis < 3; ++axis) {
            slab[axis] = {slabs.at(axis, -prim_ref.negated_lower[axis]),
                          slabs.at(axis, prim_ref.upper[axis])};
            ++contents[axis].begin[slab[axis].lower];
            ++contents[axis].end[slab[axis].upper];
            if (slab[axis].lower == slab[axis].upper) {
                grow(contents[axis].box[slab[axis].lower], box);
            } else {
                is_cut = true;
            }
        }
        if (!is_cut) continue;
        const CutTriangle triangle(mesh, prim_ref.id);
        for (std::size_t axis = 0; axis < 3; ++axis) {
            if (slab[axis].lower == slab[axis].upper) continue;
            add_pieces(box, triangle, slabs, axis, slab[axis], contents[axis]);
        }
    }
}

// The boxes of a PrimRef's parts on both sides of a plane. A PrimRef that the plane does not cut,
// or whose part on one side is empty, is whole on the other side.
inline Parts pieces_of(const PrimRef& prim_ref, const MeshArrays& mesh, CutPlane plane) noexcept {
    const Lanes box = lanes_of(prim_ref);
    const Lanes none = load_box(empty_box);
    if (prim_ref.upper[plane.axis] <= plane.position) return {box, none};
    if (-prim_ref.negated_lower[plane.axis] >= plane.position) return {none, box};
    const CutTriangle triangle(mesh, prim_ref.id);
    const Parts parts = cut(box, triangle, CornersAlong(triangle, plane.axis), plane);
    if (!has_extent(parts.upper)) return {box, none};
    if (!has_extent(parts.lower)) return {none, box};
    return parts;
}

Sides<std::uint32_t> count_pieces(std::span<const PrimRef> prim_refs, const MeshArrays& mesh,
                                  CutPlane plane) noexcept {
    Sides<std::uint32_t> count{0, 0};
    for (const PrimRef& prim_ref : prim_refs) {
        const Parts pieces = pieces_of(prim_ref, mesh, plane);
        count.lower += has_extent(pieces.lower) ? 1U : 0U;
        count.upper += has_extent(pieces.upper) ? 1U : 0U;
    }
    return count;
}

inline void write_piece(const PrimRef& prim_ref, Lanes piece, PrimRef*& out,
                        Measure& measure) noexcept {
    if (!has_extent(piece)) return;
    store_unaligned(piece, out->negated_lower.data());
    out->id = prim_ref.id;
    out->weight = prim_ref.weight;
    ++out;
    grow(measure.box, piece);
    grow(measure.centroids, centroid_of(piece));
}

void write_pieces(std::span<const PrimRef> prim_refs, const MeshArrays& mesh, CutPlane plane,
                  Sides<PrimRef*> out, Sides<Measure>& measure) noexcept {
    for (const PrimRef& prim_ref : prim_refs) {
        const Parts pieces = pieces_of(prim_ref, mesh, plane);
        write_piece(prim_ref, pieces.lower, out.lower, measure.lower);
        write_piece(prim_ref, pieces.upper, out.upper, measure.upper);
    }
}

}  // namespace COPPICE_SIMD_SET
}  // namespace
}  // namespace coppice::inline v0::bvh8

COPPICE_SIMD_END

#endif
