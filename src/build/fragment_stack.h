#pragma once

#include "coppice/build/split_finder.h"

#include "build/partition.h"

#include <cstddef>
#include <span>
#include <utility>
#include <vector>

namespace coppice {

/// The fragments of a node and of all that still waits while one task goes down depth first, in one
/// array: a node's fragments are on top; dividing them leaves the upper child's in their place and
/// puts the lower child's on top. So no node allocates.
class FragmentStack {
public:
    /// The stack of a root with these fragments.
    explicit FragmentStack(std::vector<Fragment> fragments)
        : fragments_(std::move(fragments)), size_(fragments_.size()) {}

    /// The topmost `count` fragments; valid until the next division.
    [[nodiscard]] std::span<const Fragment> top(std::size_t count) const noexcept {
        return std::span(fragments_).subspan(size_ - count, count);
    }

    /// How many fragments a division left on each side.
    struct Sides {
        std::size_t below;
        std::size_t above;
    };

    /// Divides the topmost `count` fragments; those below the plane are on top afterwards.
    Sides divide_top(std::size_t count, Plane plane, PlanarSide planar_side,
                     const Division& division);

    void pop(std::size_t count) noexcept { size_ -= count; }

private:
    std::vector<Fragment> fragments_;
    std::size_t size_;
};

}  // namespace coppice
