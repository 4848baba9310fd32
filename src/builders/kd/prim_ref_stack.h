#pragma once

#include "coppice/builders/split_finder.h"

#include "builders/kd/partition.h"

#include <cstddef>
#include <span>
#include <utility>
#include <vector>

namespace coppice::inline v0 {

/// The PrimRefs of a node and of all waiting nodes in one array, while one task descends depth
/// first. A node's PrimRefs are on top. Dividing them leaves the upper child's in their place and
/// puts the lower child's on top. So no node allocates memory.
class PrimRefStack {
public:
    /// A stack that holds the PrimRefs of a root.
    explicit PrimRefStack(std::vector<PrimRef> prim_refs)
        : prim_refs_(std::move(prim_refs)), size_(prim_refs_.size()) {}

    /// The topmost `count` PrimRefs; valid until the next division.
    [[nodiscard]] std::span<const PrimRef> top(std::size_t count) const noexcept {
        return std::span(prim_refs_).subspan(size_ - count, count);
    }

    /// The number of PrimRefs on each side after a division.
    struct Sides {
        std::size_t below;
        std::size_t above;
    };

    /// Divides the topmost `count` PrimRefs. Those below the plane are on top afterwards.
    Sides divide_top(std::size_t count, SplitPlane plane, PlanarSide planar_side,
                     const Division& division);

    void pop(std::size_t count) noexcept { size_ -= count; }

private:
    std::vector<PrimRef> prim_refs_;
    std::size_t size_;
};

}  // namespace coppice::inline v0
