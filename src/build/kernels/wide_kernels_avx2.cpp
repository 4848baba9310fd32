#include "build/kernels/wide_kernels_sets.h"

#if defined(__x86_64__)

#include "base/isa.h"

#include <immintrin.h>

#include <algorithm>

namespace coppice::wide {

COPPICE_BEGIN_AVX2

namespace {

#include "build/kernels/lanes_avx2.inl"
#include "build/kernels/wide_kernels.inl"

}  // namespace

COPPICE_END_ISA

const Kernels& avx2_kernels() noexcept {
    return kernels;
}

}  // namespace coppice::wide

#endif
