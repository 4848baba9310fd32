#include "builders/kernels/kd_kernels.h"

#define COPPICE_SIMD_KERNELS "builders/kernels/kd_kernels_set.h"
#define COPPICE_SIMD_SETS COPPICE_SIMD_AVX2
#include "simd/foreach_set.h"

namespace coppice::inline v0 {

const KdKernels& kd_kernels_for(Isa isa) noexcept {
    static constexpr simd::Tables<KdKernels> tables COPPICE_SIMD_TABLES;
    return tables.at(isa);
}

}  // namespace coppice::inline v0
