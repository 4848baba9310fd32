#pragma once

#include "builders/kernels/bvh8_kernels.h"

#include <cstdint>
#include <span>

namespace coppice::inline v0::bvh8 {

/// A range of PrimRefs in one of the two buffers of a build, with what is needed to split it.
struct Range {
    std::uint32_t begin = 0;
    std::uint32_t end = 0;
    std::uint8_t buffer = 0;
    Box8 box = Box8::make_empty();
    Box8 centroids = Box8::make_empty();
    std::uint32_t spare_below = 0;  ///< free slots before `begin`, in both buffers
    std::uint32_t spare_above = 0;  ///< free slots from `end` on, in both buffers

    [[nodiscard]] std::uint32_t size() const noexcept { return end - begin; }

    /// The number of PrimRefs that fit into the range with its spare room.
    [[nodiscard]] std::uint32_t room() const noexcept { return spare_below + size() + spare_above; }
};

/// The two halves of a split range.
using Halves = Sides<Range>;

/// Places two halves of `count` PrimRefs in the room of a range, in the other buffer. They share
/// the spare room in proportion to their counts. Their boxes are empty.
[[nodiscard]] Halves place_halves(const Range& range, Sides<std::uint32_t> count) noexcept;

/// Splits ranges of PrimRefs by binned SAH over their centroids, and copies them from one of two
/// buffers to the other. The result does not depend on the number of threads.
/// Source: [Wald2007] sec. 3.
class Splitter {
public:
    /// Works on two buffers of equal length. `costs` determines the cost of a split.
    Splitter(std::span<PrimRef> first, std::span<PrimRef> second, const SplitCosts& costs,
             const Kernels& kernels) noexcept
        : buffers_{first, second}, costs_(costs), kernels_(kernels) {}

    /// The PrimRefs of a range.
    [[nodiscard]] std::span<const PrimRef> prim_refs(const Range& range) const noexcept {
        return buffers_[range.buffer].subspan(range.begin, range.size());
    }

    /// A range with its box and centroid bounds computed.
    [[nodiscard]] Range measured(std::uint32_t begin, std::uint32_t end, std::uint8_t buffer) const;

    /// The cheapest split of a range; bin 0 if there is none. Sets `mapping` to the binning that
    /// the split refers to.
    [[nodiscard]] ObjectSplit find(const Range& range, BinMapping& mapping) const;

    /// Divides a range at a split. If `split` has bin 0, does what halve() does.
    [[nodiscard]] Halves divide(const Range& range, const ObjectSplit& split,
                                const BinMapping& mapping) const;

    /// Divides a range at half of its PrimRefs, in their current order.
    [[nodiscard]] Halves halve(const Range& range) const;

private:
    [[nodiscard]] ObjectSplit find_in_chunks(const Range& range, const BinMapping& mapping) const;
    [[nodiscard]] Halves divide_in_chunks(const Range& range, const ObjectSplit& split,
                                          const BinMapping& mapping) const;

    std::array<std::span<PrimRef>, 2> buffers_;
    SplitCosts costs_;
    const Kernels& kernels_;
};

/// A power of two that scales the longest edge of a box to about 1, so that areas neither overflow
/// nor underflow.
[[nodiscard]] float extent_factor_of(const Box8& box) noexcept;

}  // namespace coppice::inline v0::bvh8
