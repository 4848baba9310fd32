// Bins both ends of all PrimRefs on all axes in one pass. A PrimRef is loaded as eight lanes, of
// which the first six are positions. Cost: O(PrimRefs).

#include "simd/set.h"

#if defined(COPPICE_BUILDERS_KERNELS_BIN_KERNELS_H) == defined(COPPICE_SIMD_TOGGLE)
#ifdef COPPICE_SIMD_TOGGLE
#undef COPPICE_BUILDERS_KERNELS_BIN_KERNELS_H
#else
#define COPPICE_BUILDERS_KERNELS_BIN_KERNELS_H
#endif

#include "builders/kernels/bin_ends.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include COPPICE_SIMD_LANES

COPPICE_SIMD_BEGIN

namespace coppice::inline v0 {
namespace {
namespace COPPICE_SIMD_SET {

using namespace simd::COPPICE_SIMD_SET;

// Spreads a vector with a value per axis over the lanes of both ends.
inline Lanes on_ends(Vec3f v) noexcept {
    return join(make_quad(v.x, v.y, v.z, v.x), make_quad(v.y, v.z, 0.0F, 0.0F));
}

void bin_ends(std::span<const PrimRef> prim_refs, const BinGrid& grid, NodeBins& bins) noexcept {
    static_assert(offsetof(PrimRef, box) == 0 && sizeof(Aabb) == 6 * sizeof(float));
    const Lanes origin = on_ends(grid.origin);
    const Lanes bins_per_unit = on_ends(grid.bins_per_unit);
    const Lanes first = broadcast(0.0F);
    const Lanes last = broadcast(static_cast<float>(bin_count - 1));
    for (const PrimRef& prim_ref : prim_refs) {
        const Lanes ends = load_unaligned(&prim_ref.box.lower.x);
        alignas(32) std::array<std::int32_t, 8> bin;
        store_integers(max(min((ends - origin) * bins_per_unit, last), first), bin);
        for (std::size_t axis = 0; axis < 3; ++axis) {
            const auto index = static_cast<Axis>(axis);
            bins[axis].add_start(static_cast<std::size_t>(bin[axis]), prim_ref.box.lower[index],
                                 prim_ref.weight);
            bins[axis].add_end(static_cast<std::size_t>(bin[3 + axis]), prim_ref.box.upper[index],
                               prim_ref.weight);
        }
    }
}

}  // namespace COPPICE_SIMD_SET
}  // namespace
}  // namespace coppice::inline v0

COPPICE_SIMD_END

#endif
