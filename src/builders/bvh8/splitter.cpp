// Binned SAH splits of triangle PrimRefs by their centroids. A range of n PrimRefs is put into
// min(16, 4 + n / 4) bins per axis; more bins changed the cost by less than 0.5 %. The cheapest
// border between bins is chosen, and the PrimRefs are copied in order to the other buffer. No
// branch depends on the data. Large ranges are binned and copied in parallel chunks.
// Source: [Wald2007] sec. 3.

#include "builders/bvh8/splitter.h"

#include "builders/bvh8/chunks.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace coppice::inline v0::bvh8 {
namespace {

BinMapping map_bins(const Range& range) {
    BinMapping mapping{};
    mapping.bin_count =
        std::min<std::uint32_t>(static_cast<std::uint32_t>(max_bin_count), 4 + range.size() / 4);
    for (std::size_t axis = 0; axis < 3; ++axis) {
        mapping.origin[axis] = range.centroids.lower(axis);
        const float extent = range.centroids.upper(axis) - mapping.origin[axis];
        const float scale = static_cast<float>(mapping.bin_count) / extent;
        mapping.scale[axis] = std::isfinite(scale) && extent > 0.0F ? scale : 0.0F;
    }
    return mapping;
}

std::uint32_t count_lower(std::span<const PrimRef> prim_refs, const ObjectSplit& split,
                          const BinMapping& mapping) {
    std::uint32_t count = 0;
    for (const PrimRef& prim_ref : prim_refs) {
        count += mapping.bin_of(prim_ref, split.axis) < split.bin ? 1U : 0U;
    }
    return count;
}

// The two halves of a split in the other buffer, with centroid bounds not computed yet.
Halves halves_of(const Range& range, const ObjectSplit& split, std::uint32_t lower_count) {
    Halves halves = place_halves(range, {lower_count, range.size() - lower_count});
    halves.lower.box = split.lower_box;
    halves.upper.box = split.upper_box;
    return halves;
}

}  // namespace

Halves place_halves(const Range& range, Sides<std::uint32_t> count) noexcept {
    const std::uint64_t sum = std::uint64_t{count.lower} + count.upper;
    const std::uint64_t spare = range.room() - sum;
    const auto spare_below = static_cast<std::uint32_t>(spare * count.lower / sum);
    const auto buffer = static_cast<std::uint8_t>(1 - range.buffer);
    Halves halves{{.buffer = buffer}, {.buffer = buffer}};
    halves.lower.begin = range.begin - range.spare_below;
    halves.lower.end = halves.lower.begin + count.lower;
    halves.lower.spare_above = spare_below;
    halves.upper.begin = halves.lower.end + spare_below;
    halves.upper.end = halves.upper.begin + count.upper;
    halves.upper.spare_above = static_cast<std::uint32_t>(spare) - spare_below;
    return halves;
}

float extent_factor_of(const Box8& box) noexcept {
    float longest = 0.0F;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        longest = std::max(longest, 0.5F * box.upper(axis) - 0.5F * box.lower(axis));
    }
    if (!(longest > 0.0F)) return 1.0F;
    return std::ldexp(1.0F, std::clamp(-std::ilogb(longest), -126, 126));
}

Range Splitter::measured(std::uint32_t begin, std::uint32_t end, std::uint8_t buffer) const {
    Range range{.begin = begin, .end = end, .buffer = buffer};
    const auto prim_refs = this->prim_refs(range);
    if (!Chunks::are_worth_it(prim_refs.size())) {
        kernels_.unite(prim_refs, range.box, range.centroids);
        return range;
    }
    const Chunks chunks(prim_refs.size());
    std::vector<Range> parts(chunks.count());
    chunks.for_each([&](std::size_t chunk, std::size_t first, std::size_t last) {
        kernels_.unite(prim_refs.subspan(first, last - first), parts[chunk].box,
                       parts[chunk].centroids);
    });
    for (const Range& part : parts) {
        range.box.grow(part.box);
        range.centroids.grow(part.centroids);
    }
    return range;
}

ObjectSplit Splitter::find(const Range& range, BinMapping& mapping) const {
    mapping = map_bins(range);
    if (Chunks::are_worth_it(range.size())) return find_in_chunks(range, mapping);
    Bins bins;
    clear(bins, mapping.bin_count);
    kernels_.bin(prim_refs(range), mapping, bins);
    return kernels_.find_split(bins, mapping.bin_count, costs_);
}

ObjectSplit Splitter::find_in_chunks(const Range& range, const BinMapping& mapping) const {
    const auto prim_refs = this->prim_refs(range);
    const Chunks chunks(prim_refs.size());
    std::vector<Bins> parts(chunks.count());
    chunks.for_each([&](std::size_t chunk, std::size_t first, std::size_t last) {
        clear(parts[chunk], mapping.bin_count);
        kernels_.bin(prim_refs.subspan(first, last - first), mapping, parts[chunk]);
    });
    Bins& bins = parts.front();
    for (const Bins& part : std::span(parts).subspan(1)) {
        for (std::size_t axis = 0; axis < 3; ++axis) {
            for (std::uint32_t at = 0; at < mapping.bin_count; ++at) {
                bins.box[axis][at].grow(part.box[axis][at]);
                bins.weight[axis][at] += part.weight[axis][at];
            }
        }
    }
    return kernels_.find_split(bins, mapping.bin_count, costs_);
}

Halves Splitter::halve(const Range& range) const {
    const std::uint32_t middle = range.begin + (range.size() + 1) / 2;
    Halves halves{measured(range.begin, middle, range.buffer),
                  measured(middle, range.end, range.buffer)};
    halves.lower.spare_below = range.spare_below;
    halves.upper.spare_above = range.spare_above;
    return halves;
}

Halves Splitter::divide(const Range& range, const ObjectSplit& split,
                        const BinMapping& mapping) const {
    if (split.bin == 0) return halve(range);
    if (Chunks::are_worth_it(range.size())) return divide_in_chunks(range, split, mapping);
    const auto prim_refs = this->prim_refs(range);
    // Weights of 1 sum up to their number exactly, since there are fewer than 2^24 of them.
    const std::uint32_t lower_count = costs_.whole_blocks
                                          ? static_cast<std::uint32_t>(split.lower_weight)
                                          : count_lower(prim_refs, split, mapping);
    Halves halves = halves_of(range, split, lower_count);
    PrimRef* out = buffers_[halves.lower.buffer].data();
    Sides<Box8> centroids{Box8::make_empty(), Box8::make_empty()};
    kernels_.partition(prim_refs, {mapping, split.axis, split.bin},
                       {out + halves.lower.begin, out + halves.upper.begin}, centroids);
    halves.lower.centroids = centroids.lower;
    halves.upper.centroids = centroids.upper;
    return halves;
}

Halves Splitter::divide_in_chunks(const Range& range, const ObjectSplit& split,
                                  const BinMapping& mapping) const {
    const auto prim_refs = this->prim_refs(range);
    const Chunks chunks(prim_refs.size());
    std::vector<std::uint32_t> lower_begin(chunks.count());  // per chunk
    chunks.for_each([&](std::size_t chunk, std::size_t first, std::size_t last) {
        lower_begin[chunk] = count_lower(prim_refs.subspan(first, last - first), split, mapping);
    });
    std::uint32_t lower_count = 0;
    for (std::uint32_t& count : lower_begin) {
        count = std::exchange(lower_count, lower_count + count);
    }

    Halves halves = halves_of(range, split, lower_count);
    PrimRef* out = buffers_[halves.lower.buffer].data();
    std::vector<Sides<Box8>> parts(lower_begin.size(), {Box8::make_empty(), Box8::make_empty()});
    chunks.for_each([&](std::size_t chunk, std::size_t first, std::size_t last) {
        const std::size_t lower = lower_begin[chunk];
        kernels_.partition(
            prim_refs.subspan(first, last - first), {mapping, split.axis, split.bin},
            {out + halves.lower.begin + lower, out + halves.upper.begin + (first - lower)},
            parts[chunk]);
    });
    for (const Sides<Box8>& part : parts) {
        halves.lower.centroids.grow(part.lower);
        halves.upper.centroids.grow(part.upper);
    }
    return halves;
}

}  // namespace coppice::inline v0::bvh8
