#include "query/kernels/point_search.h"

#define COPPICE_SIMD_KERNELS "query/kernels/point_search_set.h"
#define COPPICE_SIMD_SETS COPPICE_SIMD_AVX2
#include "simd/foreach_set.h"

namespace coppice::inline v0 {

const PointSearchKernels& point_search_kernels_for(Isa isa) noexcept {
    static constexpr simd::Tables<PointSearchKernels> tables COPPICE_SIMD_TABLES;
    return tables.at(isa);
}

}  // namespace coppice::inline v0
