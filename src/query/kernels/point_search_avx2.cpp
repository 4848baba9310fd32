#include "query/kernels/point_search.h"

#if defined(__x86_64__)

#include "base/isa.h"
#include "query/nearest_set.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <utility>

namespace coppice::inline v0 {

COPPICE_BEGIN_AVX2

namespace {

#include "query/kernels/point_search.inl"

}  // namespace

COPPICE_END_ISA

const PointSearchKernels& avx2_point_search_kernels() noexcept {
    return kernels;
}

}  // namespace coppice::inline v0

#endif
