// The inner loops of the 8-wide builder that divide PrimRefs by their centroids, on eight lanes.
// They use no fused operations, so that all instruction sets give equal results.

#include "simd/set.h"

#if defined(COPPICE_BUILDERS_KERNELS_OBJECT_KERNELS_H) == defined(COPPICE_SIMD_TOGGLE)
#ifdef COPPICE_SIMD_TOGGLE
#undef COPPICE_BUILDERS_KERNELS_OBJECT_KERNELS_H
#else
#define COPPICE_BUILDERS_KERNELS_OBJECT_KERNELS_H
#endif

#include "builders/kernels/boxes.h"
#include "builders/kernels/bvh8_kernels.h"
#include "cost/split_cost.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>

#include COPPICE_SIMD_LANES

COPPICE_SIMD_BEGIN

namespace coppice::inline v0::bvh8 {
namespace {
namespace COPPICE_SIMD_SET {

using namespace simd::COPPICE_SIMD_SET;

void unite(std::span<const PrimRef> prim_refs, Box8& box, Box8& centroids) noexcept {
    Lanes united = load_box(box);
    Lanes centroid_range = load_box(centroids);
    for (const PrimRef& prim_ref : prim_refs) {
        const Lanes lanes = lanes_of(prim_ref);
        united = max(lanes, united);
        centroid_range = max(centroid_of(lanes), centroid_range);
    }
    store_box(united, box);
    store_box(centroid_range, centroids);
}

inline void add_to_bin(Bins& bins, std::size_t axis, std::uint32_t bin, Lanes lanes,
                       float weight) noexcept {
    grow(bins.box[axis][bin], lanes);
    bins.weight[axis][bin] += weight;
}

inline void add(Bins& bins, const Binner& bin_of, const PrimRef& prim_ref) noexcept {
    const Lanes lanes = lanes_of(prim_ref);
    const std::array<std::uint32_t, 3> at = bin_of(lanes);
    add_to_bin(bins, 0, at[0], lanes, prim_ref.weight);
    add_to_bin(bins, 1, at[1], lanes, prim_ref.weight);
    add_to_bin(bins, 2, at[2], lanes, prim_ref.weight);
}

// Neighbours in the mesh fall into the same bin, and each update of a bin waits for the store
// before it. Two sets of bins used in turns halve that wait. From this number of PrimRefs on, that
// outweighs the cost of merging them.
constexpr std::size_t min_two_sets = 128;

void bin(std::span<const PrimRef> prim_refs, const BinMapping& mapping, Bins& bins) noexcept {
    const Binner bin_of(mapping);
    if (prim_refs.size() < min_two_sets) {
        for (const PrimRef& prim_ref : prim_refs) {
            add(bins, bin_of, prim_ref);
        }
        return;
    }
    Bins others;
    clear(others, mapping.bin_count);
    const std::size_t even = prim_refs.size() / 2 * 2;
    for (std::size_t at = 0; at < even; at += 2) {
        add(bins, bin_of, prim_refs[at]);
        add(others, bin_of, prim_refs[at + 1]);
    }
    if (even < prim_refs.size()) add(bins, bin_of, prim_refs[even]);
    for (std::size_t axis = 0; axis < 3; ++axis) {
        for (std::uint32_t at = 0; at < mapping.bin_count; ++at) {
            add_to_bin(bins, axis, at, load_box(others.box[axis][at]), others.weight[axis][at]);
        }
    }
}

using PerBin = std::array<float, max_bin_count>;

// For each border, the bins on one side of it: half the area of their box, and their weight.
struct Side {
    alignas(32) PerBin area;
    alignas(32) PerBin weight;
};

// Sums up the bins below each border. Border `at` is between bins at - 1 and at.
inline void sum_below(const std::array<Box8, max_bin_count>& boxes, const PerBin& weights,
                      std::uint32_t bin_count, float factor, Side& below) noexcept {
    Lanes box = load_box(boxes[0]);
    float weight = weights[0];
    for (std::uint32_t at = 1; at < bin_count; ++at) {
        below.area[at] = half_area(box, factor);
        below.weight[at] = weight;
        box = max(load_box(boxes[at]), box);
        weight += weights[at];
    }
}

inline void sum_above(const std::array<Box8, max_bin_count>& boxes, const PerBin& weights,
                      std::uint32_t bin_count, float factor, Side& above) noexcept {
    Lanes box = load_box(boxes[bin_count - 1]);
    float weight = weights[bin_count - 1];
    for (std::uint32_t at = bin_count - 1; at > 0; --at) {
        above.area[at] = half_area(box, factor);
        above.weight[at] = weight;
        box = max(load_box(boxes[at - 1]), box);
        weight += weights[at - 1];
    }
}

// Computes the cost of every border; infinite if a side is empty.
inline void cost_borders(const Side& below, const Side& above, const SplitCosts& costs,
                         PerBin& cost) noexcept {
    constexpr std::size_t lane_count = 8;
    const Lanes nothing = broadcast(0.0F);
    const Lanes round_up = broadcast(costs.whole_blocks ? costs.block_size - 1.0F : 0.0F);
    const Lanes per_block = broadcast(1.0F / costs.block_size);
    const auto blocks_of = [&](Lanes weight) {
        const Lanes blocks = (weight + round_up) * per_block;
        return costs.whole_blocks ? truncate(blocks) : blocks;
    };
    for (std::size_t at = 0; at < max_bin_count; at += lane_count) {
        const Lanes weight_below = load_unaligned(&below.weight[at]);
        const Lanes weight_above = load_unaligned(&above.weight[at]);
        const Lanes both = sah::COPPICE_SIMD_SET::weighted_areas(
            load_unaligned(&below.area[at]), blocks_of(weight_below),
            load_unaligned(&above.area[at]), blocks_of(weight_above));
        const Mask is_split = is_less(nothing, weight_below) & is_less(nothing, weight_above);
        const Lanes none = broadcast(std::numeric_limits<float>::infinity());
        store_unaligned(select(is_split, both, none), &cost[at]);
    }
}

void unite_sides(const std::array<Box8, max_bin_count>& boxes, std::uint32_t bin_count,
                 ObjectSplit& split) noexcept {
    Lanes lower = load_box(boxes[0]);
    Lanes upper = load_box(boxes[split.bin]);
    for (std::uint32_t at = 1; at < split.bin; ++at) {
        lower = max(load_box(boxes[at]), lower);
    }
    for (std::uint32_t at = split.bin + 1; at < bin_count; ++at) {
        upper = max(load_box(boxes[at]), upper);
    }
    store_box(lower, split.lower_box);
    store_box(upper, split.upper_box);
}

// The bins of one axis.
struct BinnedAxis {
    std::uint32_t axis;
    const std::array<Box8, max_bin_count>& boxes;
    const PerBin& weights;
    std::uint32_t bin_count;
};

// Replaces the best split by the cheapest border on an axis if that is cheaper.
inline void improve_split(const BinnedAxis& bins, const SplitCosts& costs,
                          ObjectSplit& best) noexcept {
    Side below{};
    Side above{};
    alignas(32) PerBin cost;
    sum_below(bins.boxes, bins.weights, bins.bin_count, costs.extent_factor, below);
    sum_above(bins.boxes, bins.weights, bins.bin_count, costs.extent_factor, above);
    cost_borders(below, above, costs, cost);
    const auto least = std::min_element(cost.begin() + 1, cost.begin() + bins.bin_count);
    if (!(*least < best.cost)) return;
    best.cost = *least;
    best.axis = bins.axis;
    best.bin = static_cast<std::uint32_t>(least - cost.begin());
    best.lower_weight = below.weight[best.bin];
}

ObjectSplit find_split(const Bins& bins, std::uint32_t bin_count,
                       const SplitCosts& costs) noexcept {
    ObjectSplit best;
    for (std::uint32_t axis = 0; axis < 3; ++axis) {
        improve_split({axis, bins.box[axis], bins.weight[axis], bin_count}, costs, best);
    }
    if (best.bin != 0) unite_sides(bins.box[best.axis], bin_count, best);
    return best;
}

void partition(std::span<const PrimRef> prim_refs, const Border& border, Sides<PrimRef*> out,
               Sides<Box8>& centroids) noexcept {
    std::array<PrimRef*, 2> next{out.lower, out.upper};
    const Lanes none = load_box(empty_box);
    Lanes lower_range = load_box(centroids.lower);
    Lanes upper_range = load_box(centroids.upper);
    for (const PrimRef& prim_ref : prim_refs) {
        const Lanes lanes = lanes_of(prim_ref);
        const bool is_upper = border.mapping.bin_of(prim_ref, border.axis) >= border.bin;
        const std::size_t side = is_upper ? 1 : 0;
        store_unaligned(lanes, next[side]->negated_lower.data());
        ++next[side];
        const Lanes centroid = centroid_of(lanes);
        lower_range = max(choose(side == 0, centroid, none), lower_range);
        upper_range = max(choose(side != 0, centroid, none), upper_range);
    }
    store_box(lower_range, centroids.lower);
    store_box(upper_range, centroids.upper);
}

void fill_block(std::span<const std::uint32_t> ids, const MeshArrays& mesh,
                TriangleBlock& block) noexcept {
    std::array<const float*, 8> corner;
    for (std::size_t vertex = 0; vertex < 3; ++vertex) {
        for (std::size_t lane = 0; lane < 8; ++lane) {
            corner[lane] = lane < ids.size() ? &mesh.vertices[mesh.triangles[ids[lane]][vertex]].x
                                             : &nowhere.x;
        }
        const std::array<Lanes, 3> axes = load_points(corner);
        for (std::size_t axis = 0; axis < 3; ++axis) {
            store(axes[axis], block.corner[vertex][axis]);
        }
    }
    for (std::size_t lane = 0; lane < 8; ++lane) {
        block.id[lane] = lane < ids.size() ? ids[lane] : TriangleBlock::no_triangle;
    }
}

}  // namespace COPPICE_SIMD_SET
}  // namespace
}  // namespace coppice::inline v0::bvh8

COPPICE_SIMD_END

#endif
