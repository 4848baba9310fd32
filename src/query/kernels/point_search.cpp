#include "query/kernels/point_search.h"

namespace coppice {

const PointSearchKernels& point_search_kernels_for(Isa isa) noexcept {
    return isa == Isa::avx2 ? avx2_point_search_kernels() : scalar_point_search_kernels();
}

}  // namespace coppice
