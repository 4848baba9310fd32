// Spatial splits of triangle PrimRefs (SBVH). If the halves of an object split would overlap, the
// range's box is divided into 16 slabs on each axis, and triangles are clipped to them. The
// cheapest border between slabs competes with the object split. A triangle that is cut is in both
// halves. Ranges therefore have spare room, which the halves share in proportion to their sizes;
// without room there are no more spatial splits. In large ranges a sample chooses the border. The
// halves are then kept only if their actual cost is lower, because a sample alone is too
// optimistic. Cost: about twice that of the object split.
// Source: [Stich2009] sec. 4.

#include "builders/bvh8/spatial_splitter.h"

#include "builders/bvh8/chunks.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

namespace coppice::inline v0::bvh8 {
namespace {

// The least overlap, relative to the scene's surface area. Halves that overlap less gain nothing
// from a spatial split [Stich2009].
constexpr float least_overlap = 1e-5F;

// Smaller ranges are not split spatially: that would take half of the time and gain 0.3 % of the
// cost.
constexpr std::uint32_t least_size = 512;

// From this size on, one PrimRef in four chooses the border. This saves a third of the time and
// changes the cost by less than 0.4 %.
constexpr std::uint32_t sampled_from = 4096;
constexpr std::uint32_t one_in = 4;

// Computations on the edges of larger scenes would overflow.
constexpr float largest_extent = 0x1.0p100F;

bool is_empty(const Box8& box) noexcept {
    return box.lower(0) > box.upper(0);
}

// Half the surface area, with edges multiplied by `factor`; 0 for an empty box.
float half_area(const Box8& box, float factor) noexcept {
    if (is_empty(box)) return 0.0F;
    const float x = (box.upper(0) - box.lower(0)) * factor;
    const float y = (box.upper(1) - box.lower(1)) * factor;
    const float z = (box.upper(2) - box.lower(2)) * factor;
    return x * y + y * z + z * x;
}

float overlap_area(const ObjectSplit& split, float factor) noexcept {
    Box8 common;
    for (std::size_t i = 0; i < common.lane.size(); ++i) {
        common.lane[i] = std::min(split.lower_box.lane[i], split.upper_box.lane[i]);
    }
    for (std::size_t axis = 0; axis < 3; ++axis) {
        if (common.lower(axis) > common.upper(axis)) return 0.0F;
    }
    return half_area(common, factor);
}

// The lower border of a slab, and the cost of a split there in the unit of ObjectSplit::cost.
struct SlabBorder {
    std::size_t slab = 0;
    float cost = std::numeric_limits<float>::infinity();
};

// The cost of one side of a split.
float cost_of(const Box8& box, std::uint32_t count, float factor) noexcept {
    constexpr std::uint32_t block_size = bvh8_width;
    const std::uint32_t blocks = (count + block_size - 1) / block_size;
    return half_area(box, factor) * static_cast<float>(blocks);
}

// The cheapest border with fewer PrimRefs on each side than the range has. Every counted PrimRef
// stands for `stride`.
SlabBorder cheapest_border(const SlabContents& contents, std::uint32_t stride,
                           std::uint32_t reference_count, float factor) noexcept {
    std::array<float, slab_count> cost_above;
    Box8 box = Box8::make_empty();
    std::uint32_t count = 0;
    const auto add = [&](std::size_t slab, std::uint32_t counted) {
        box.grow(contents.box[slab]);
        count += counted * stride;
        return count < reference_count ? cost_of(box, count, factor)
                                       : std::numeric_limits<float>::infinity();
    };
    for (std::size_t slab = slab_count - 1; slab > 0; --slab) {
        cost_above[slab] = add(slab, contents.end[slab]);
    }
    box = Box8::make_empty();
    count = 0;
    SlabBorder best;
    for (std::size_t slab = 1; slab < slab_count; ++slab) {
        const float cost = add(slab - 1, contents.begin[slab - 1]) + cost_above[slab];
        if (cost < best.cost) best = {slab, cost};
    }
    return best;
}

void add(const Measure& measure, Range& range) noexcept {
    range.box.grow(measure.box);
    range.centroids.grow(measure.centroids);
}

}  // namespace

SpatialSplitter::SpatialSplitter(std::span<PrimRef> first, std::span<PrimRef> second,
                                 TriangleMeshView mesh, const Box8& bounds,
                                 const Kernels& kernels) noexcept
    : buffers_{first, second},
      mesh_{mesh.vertices().data(), mesh.triangles().data()},
      factor_(extent_factor_of(bounds)),
      least_overlap_(least_overlap * half_area(bounds, factor_)),
      can_calculate_(factor_ * largest_extent >= 1.0F),
      kernels_(kernels) {}

std::span<const PrimRef> SpatialSplitter::prim_refs(const Range& range) const noexcept {
    return buffers_[range.buffer].subspan(range.begin, range.size());
}

SpatialSplitter::Cut SpatialSplitter::find(const Range& range) const {
    const auto prim_refs = this->prim_refs(range);
    const Slabs slabs(range.box);
    const std::uint32_t stride = range.size() < sampled_from ? 1 : one_in;
    const Chunks chunks(prim_refs.size());
    std::vector<std::array<SlabContents, 3>> parts(chunks.count());
    chunks.for_each([&](std::size_t chunk, std::size_t begin, std::size_t end) {
        kernels_.bin_pieces(prim_refs.subspan(begin, end - begin), stride, mesh_, slabs,
                            parts[chunk]);
    });
    for (const auto& part : std::span(parts).subspan(1)) {
        for (std::size_t axis = 0; axis < 3; ++axis) {
            parts.front()[axis].add(part[axis]);
        }
    }
    Cut best;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const SlabBorder border =
            cheapest_border(parts.front()[axis], stride, range.size(), factor_);
        if (border.cost < best.cost) best = Cut{slabs.below(axis, border.slab), border.cost};
    }
    return best;
}

std::optional<Halves> SpatialSplitter::divide(const Range& range, CutPlane plane) const {
    const auto prim_refs = this->prim_refs(range);
    const Chunks chunks(prim_refs.size());
    std::vector<Sides<std::uint32_t>> begins(chunks.count());  // per chunk
    chunks.for_each([&](std::size_t chunk, std::size_t begin, std::size_t end) {
        begins[chunk] = kernels_.count_pieces(prim_refs.subspan(begin, end - begin), mesh_, plane);
    });
    Sides<std::uint32_t> sum{0, 0};
    for (Sides<std::uint32_t>& begin : begins) {
        begin = std::exchange(sum, {sum.lower + begin.lower, sum.upper + begin.upper});
    }
    const bool divides = sum.lower < range.size() && sum.upper < range.size();
    if (!divides || std::uint64_t{sum.lower} + sum.upper > range.room()) return {};

    Halves halves = place_halves(range, sum);
    PrimRef* const out = buffers_[halves.lower.buffer].data();
    std::vector<Sides<Measure>> parts(begins.size());
    chunks.for_each([&](std::size_t chunk, std::size_t begin, std::size_t end) {
        const Sides<std::uint32_t>& first = begins[chunk];
        kernels_.write_pieces(
            prim_refs.subspan(begin, end - begin), mesh_, plane,
            {out + halves.lower.begin + first.lower, out + halves.upper.begin + first.upper},
            parts[chunk]);
    });
    for (const Sides<Measure>& part : parts) {
        add(part.lower, halves.lower);
        add(part.upper, halves.upper);
    }
    return halves;
}

std::optional<Halves> SpatialSplitter::improve(const Range& range, const ObjectSplit& split) const {
    const bool may_cut = can_calculate_ && range.room() > range.size();
    if (!may_cut || range.size() < least_size) return {};
    if (split.bin != 0 && overlap_area(split, factor_) <= least_overlap_) return {};
    const Cut cut = find(range);
    if (!(cut.cost < split.cost)) return {};
    std::optional<Halves> halves = divide(range, cut.plane);
    const auto cost = [&](const Range& half) { return cost_of(half.box, half.size(), factor_); };
    if (halves && !(cost(halves->lower) + cost(halves->upper) < split.cost)) halves.reset();
    return halves;
}

}  // namespace coppice::inline v0::bvh8
