#include "trace/kernels/bvh8_trace.h"

#if defined(__x86_64__)

#include "base/isa.h"
#include "geom/triangle_error.h"
#include "trace/hit_list.h"

#include <immintrin.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <limits>
#include <span>
#include <utility>

namespace coppice::inline v0 {

COPPICE_BEGIN_AVX2

namespace {

// Each of these builds on those before.
// clang-format off
#include "trace/kernels/lanes_avx2.inl"
#include "trace/kernels/compare_avx2.inl"
#include "trace/kernels/decide_avx2.inl"
#include "trace/kernels/bvh8_trace.inl"
// clang-format on

}  // namespace

COPPICE_END_ISA

const TraceKernels& avx2_trace_kernels() noexcept {
    return kernels;
}

}  // namespace coppice::inline v0

#endif
