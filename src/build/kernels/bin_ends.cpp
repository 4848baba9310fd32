// Bins both ends of all fragments on all axes in one pass: a fragment's box is two vectors of four
// floats (the fourth lanes hold something else and are not used). Cost: O(fragments).

#include "build/kernels/bin_ends.h"

#include <cstdint>
#include <cstring>

namespace coppice {
namespace {

using Floats = float __attribute__((vector_size(16)));
using Ints = std::int32_t __attribute__((vector_size(16)));

struct Corners {
    Floats lower;  // x, y, z, and the upper x
    Floats upper;  // x, y, z, and the id
};

Corners corners_of(const Fragment& fragment) noexcept {
    static_assert(offsetof(Fragment, id) == sizeof(Aabb));
    Corners corners;
    std::memcpy(&corners.lower, &fragment.box.lower, sizeof corners.lower);
    std::memcpy(&corners.upper, &fragment.box.upper, sizeof corners.upper);
    return corners;
}

Ints bins_of(const Floats& positions, const Floats& origin, const Floats& bins_per_unit) noexcept {
    const Ints bins = __builtin_convertvector((positions - origin) * bins_per_unit, Ints);
    const Ints first{};
    const Ints last = first + (static_cast<std::int32_t>(bin_count) - 1);
    const Ints at_least_first = bins > first ? bins : first;
    return at_least_first < last ? at_least_first : last;
}

Floats vector_of(Vec3f v) noexcept {
    return Floats{v.x, v.y, v.z, 0.0F};
}

}  // namespace

void bin_ends(std::span<const Fragment> fragments, const BinGrid& grid, NodeBins& bins) noexcept {
    const Floats origin = vector_of(grid.origin);
    const Floats bins_per_unit = vector_of(grid.bins_per_unit);
    for (const Fragment& fragment : fragments) {
        const Corners corners = corners_of(fragment);
        const Ints starts = bins_of(corners.lower, origin, bins_per_unit);
        const Ints ends = bins_of(corners.upper, origin, bins_per_unit);
        const double weight = fragment.weight;
        for (int axis = 0; axis < 3; ++axis) {
            AxisBins& axis_bins = bins[static_cast<std::size_t>(axis)];
            axis_bins.add_start(static_cast<std::size_t>(starts[axis]), corners.lower[axis],
                                weight);
            axis_bins.add_end(static_cast<std::size_t>(ends[axis]), corners.upper[axis], weight);
        }
    }
}

}  // namespace coppice
