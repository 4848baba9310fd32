#pragma once

#include "builders/kernels/bvh8_kernels.h"

#include <cstdint>
#include <span>

namespace coppice::inline v0::bvh8 {

/// Some of the PrimRefs of a build, in one of its two buffers, with what splitting them needs.
struct Range {
    std::uint32_t begin = 0;
    std::uint32_t end = 0;
    std::uint8_t buffer = 0;
    Box8 box = Box8::make_empty();
    Box8 centroids = Box8::make_empty();
    std::uint32_t spare_below = 0;  ///< places before `begin` that are free, in both buffers
    std::uint32_t spare_above = 0;  ///< and from `end` on

    [[nodiscard]] std::uint32_t size() const noexcept { return end - begin; }

    /// How many PrimRefs have room where it is.
    [[nodiscard]] std::uint32_t room() const noexcept { return spare_below + size() + spare_above; }
};

/// The two halves of a range that was split.
using Halves = Sides<Range>;

/// Places for so many PrimRefs in the room of a range, in the other buffer; they share what is
/// to spare by their numbers. Their boxes are empty.
[[nodiscard]] Halves place_halves(const Range& range, Sides<std::uint32_t> count) noexcept;

/// Splits ranges of PrimRefs by binned SAH over their centroids, moving them from one of two
/// buffers into the other. The same result for any number of threads.
/// Source: [Wald2007] sec. 3.
class Splitter {
public:
    /// Both buffers are as long as the PrimRefs; `costs` is what a split is judged by.
    Splitter(std::span<PrimRef> first, std::span<PrimRef> second, const SplitCosts& costs,
             const Kernels& kernels) noexcept
        : buffers_{first, second}, costs_(costs), kernels_(kernels) {}

    /// The PrimRefs of a range.
    [[nodiscard]] std::span<const PrimRef> prim_refs(const Range& range) const noexcept {
        return buffers_[range.buffer].subspan(range.begin, range.size());
    }

    /// A range with its box and centroids found.
    [[nodiscard]] Range measured(std::uint32_t begin, std::uint32_t end, std::uint8_t buffer) const;

    /// The cheapest split of a range and the mapping it is meant in; bin 0 if there is none.
    [[nodiscard]] ObjectSplit find(const Range& range, BinMapping& mapping) const;

    /// Divides a range at a split; without one, like halve().
    [[nodiscard]] Halves divide(const Range& range, const ObjectSplit& split,
                                const BinMapping& mapping) const;

    /// Divides a range in the middle as it stands.
    [[nodiscard]] Halves halve(const Range& range) const;

private:
    [[nodiscard]] ObjectSplit find_in_chunks(const Range& range, const BinMapping& mapping) const;
    [[nodiscard]] Halves divide_in_chunks(const Range& range, const ObjectSplit& split,
                                          const BinMapping& mapping) const;

    std::array<std::span<PrimRef>, 2> buffers_;
    SplitCosts costs_;
    const Kernels& kernels_;
};

/// The factor that brings the longest edge of a box to about 1, so that areas neither overflow nor
/// vanish: a power of two.
[[nodiscard]] float extent_factor_of(const Box8& box) noexcept;

}  // namespace coppice::inline v0::bvh8
