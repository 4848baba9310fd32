#include "builders/kd/prim_ref_stack.h"

#include <algorithm>

namespace coppice::inline v0 {

PrimRefStack::Sides PrimRefStack::divide_top(std::size_t count, SplitPlane plane,
                                             PlanarSide planar_side, const Division& division) {
    if (prim_refs_.size() < size_ + count) {
        prim_refs_.resize(std::max(size_ + count, prim_refs_.size() + prim_refs_.size() / 2));
    }
    const PartitionOutput begin{prim_refs_.data() + size_, prim_refs_.data() + size_ - count};
    const PartitionOutput end = divide(top(count), plane, planar_side, division, begin);
    const Sides sides{static_cast<std::size_t>(end.below - begin.below),
                      static_cast<std::size_t>(end.above - begin.above)};
    // Closes the gap that PrimRefs leave that are only below the plane.
    std::copy(begin.below, end.below, end.above);
    size_ = size_ - count + sides.above + sides.below;
    return sides;
}

}  // namespace coppice::inline v0
