#include "builders/kernels/bvh8_kernels.h"

#define COPPICE_SIMD_KERNELS "builders/kernels/bvh8_kernels_set.h"
#define COPPICE_SIMD_SETS COPPICE_SIMD_AVX2
#include "simd/foreach_set.h"

namespace coppice::inline v0::bvh8 {

const Kernels& kernels_for(Isa isa) noexcept {
    static constexpr simd::Tables<Kernels> tables COPPICE_SIMD_TABLES;
    return tables.at(isa);
}

void clear(Bins& bins, std::uint32_t bin_count) noexcept {
    for (std::size_t axis = 0; axis < 3; ++axis) {
        for (std::uint32_t bin = 0; bin < bin_count; ++bin) {
            bins.box[axis][bin] = Box8::make_empty();
            bins.weight[axis][bin] = 0.0F;
        }
    }
}

}  // namespace coppice::inline v0::bvh8
