// Lanes for AVX-512VL and DQ: lanes_256.h, with comparisons and absolute values that take one
// instruction each.
#pragma once

#include "simd/lanes_256.h"
#include "simd/target.h"

#if defined(__x86_64__)

#include <immintrin.h>

COPPICE_TARGET_AVX512

namespace coppice::inline v0::simd::avx512 {

using namespace wide256;

COPPICE_LANES Lanes larger_size(Lanes a, Lanes b) noexcept {
    constexpr int larger_without_signs = 0b1011;
    return {_mm256_range_ps(a.lane, b.lane, larger_without_signs)};
}

COPPICE_LANES unsigned less_equal(Lanes a, Lanes b) noexcept {
    return _mm256_cmp_ps_mask(a.lane, b.lane, _CMP_LE_OQ);
}

COPPICE_LANES unsigned less(Lanes a, Lanes b) noexcept {
    return _mm256_cmp_ps_mask(a.lane, b.lane, _CMP_LT_OQ);
}

COPPICE_LANES unsigned bits_less_equal(Lanes a, Lanes b) noexcept {
    return _mm256_cmple_epi32_mask(_mm256_castps_si256(a.lane), _mm256_castps_si256(b.lane));
}

}  // namespace coppice::inline v0::simd::avx512

COPPICE_TARGET_END

#endif
