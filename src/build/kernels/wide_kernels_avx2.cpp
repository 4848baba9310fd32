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

COPPICE_END_AVX2

const Kernels& avx2_kernels() noexcept {
    return kernels;
}

}  // namespace coppice::wide

#else

namespace coppice::wide {

const Kernels& avx2_kernels() noexcept {
    return scalar_kernels();  // never asked for: choose_isa() does not offer it
}

}  // namespace coppice::wide

#endif
