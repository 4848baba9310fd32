#include "query/kernels/mesh_search.h"

namespace coppice {

const MeshSearchKernels& mesh_search_kernels_for(Isa isa) noexcept {
    return isa == Isa::avx2 ? avx2_mesh_search_kernels() : scalar_mesh_search_kernels();
}

}  // namespace coppice
