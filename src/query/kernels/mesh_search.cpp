#include "query/kernels/mesh_search.h"

#define COPPICE_SIMD_KERNELS "query/kernels/mesh_search_set.h"
#define COPPICE_SIMD_SETS COPPICE_SIMD_AVX2
#include "simd/foreach_set.h"

namespace coppice::inline v0 {

const MeshSearchKernels& mesh_search_kernels_for(Isa isa) noexcept {
    static constexpr simd::Tables<MeshSearchKernels> tables COPPICE_SIMD_TABLES;
    return tables.at(isa);
}

}  // namespace coppice::inline v0
