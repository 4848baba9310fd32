#include "build/fragment_stack.h"

#include <algorithm>

namespace coppice {

FragmentStack::Sides FragmentStack::divide_top(std::size_t count, Plane plane,
                                               PlanarSide planar_side, const Division& division) {
    if (fragments_.size() < size_ + count) {
        fragments_.resize(std::max(size_ + count, fragments_.size() + fragments_.size() / 2));
    }
    const PartitionOutput begin{fragments_.data() + size_, fragments_.data() + size_ - count};
    const PartitionOutput end = divide(top(count), plane, planar_side, division, begin);
    const Sides sides{static_cast<std::size_t>(end.below - begin.below),
                      static_cast<std::size_t>(end.above - begin.above)};
    // Close the gap that the node leaves if some of its fragments are below only.
    std::copy(begin.below, end.below, end.above);
    size_ = size_ - count + sides.above + sides.below;
    return sides;
}

}  // namespace coppice
