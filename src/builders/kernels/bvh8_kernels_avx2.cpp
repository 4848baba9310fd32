#include "builders/kernels/bvh8_kernels_sets.h"

#if defined(__x86_64__)

#include "base/isa.h"

#include <immintrin.h>

#include <algorithm>

namespace coppice::inline v0::bvh8 {

COPPICE_BEGIN_AVX2

namespace {

#include "builders/kernels/lanes_avx2.inl"
#include "builders/kernels/object_kernels.inl"

}  // namespace

COPPICE_END_ISA

const Kernels& avx2_kernels() noexcept {
    return kernels;
}

}  // namespace coppice::inline v0::bvh8

#endif
