// Bins both ends of all PrimRefs on all axes in one pass: a PrimRef's box is two vectors of four
// floats (the fourth lanes hold something else and are not used). Cost: O(PrimRefs).

#include "builders/kernels/bin_ends.h"

#include <cstdint>
#include <cstring>

namespace coppice::inline v0 {
namespace {

using Floats = float __attribute__((vector_size(16)));
using Ints = std::int32_t __attribute__((vector_size(16)));

struct Corners {
    Floats lower;  // x, y, z, and the upper x
    Floats upper;  // x, y, z, and the id
};

Corners corners_of(const PrimRef& prim_ref) noexcept {
    static_assert(offsetof(PrimRef, id) == sizeof(Aabb));
    Corners corners;
    std::memcpy(&corners.lower, &prim_ref.box.lower, sizeof corners.lower);
    std::memcpy(&corners.upper, &prim_ref.box.upper, sizeof corners.upper);
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

void bin_ends(std::span<const PrimRef> prim_refs, const BinGrid& grid, NodeBins& bins) noexcept {
    const Floats origin = vector_of(grid.origin);
    const Floats bins_per_unit = vector_of(grid.bins_per_unit);
    for (const PrimRef& prim_ref : prim_refs) {
        const Corners corners = corners_of(prim_ref);
        const Ints starts = bins_of(corners.lower, origin, bins_per_unit);
        const Ints ends = bins_of(corners.upper, origin, bins_per_unit);
        const double weight = prim_ref.weight;
        for (int axis = 0; axis < 3; ++axis) {
            AxisBins& axis_bins = bins[static_cast<std::size_t>(axis)];
            axis_bins.add_start(static_cast<std::size_t>(starts[axis]), corners.lower[axis],
                                weight);
            axis_bins.add_end(static_cast<std::size_t>(ends[axis]), corners.upper[axis], weight);
        }
    }
}

}  // namespace coppice::inline v0
