#include "query/kernels/point_search.h"

namespace coppice::inline v0 {

const PointSearchKernels& point_search_kernels_for([[maybe_unused]] Isa isa) noexcept {
#if defined(__x86_64__)
    if (isa >= Isa::avx2) return avx2_point_search_kernels();
#endif
    return scalar_point_search_kernels();
}

}  // namespace coppice::inline v0
