// Lanes for AVX2: lanes_256.h, with AVX2 comparisons.
#pragma once

#include "simd/lanes_256.h"
#include "simd/target.h"

#if defined(__x86_64__)

#include <immintrin.h>

COPPICE_TARGET_AVX2

namespace coppice::inline v0::simd::avx2 {

using namespace wide256;

COPPICE_LANES Lanes larger_size(Lanes a, Lanes b) noexcept {
    return max(abs(a), abs(b));
}

COPPICE_LANES unsigned less_equal(Lanes a, Lanes b) noexcept {
    return static_cast<unsigned>(_mm256_movemask_ps(_mm256_cmp_ps(a.lane, b.lane, _CMP_LE_OQ)));
}

COPPICE_LANES unsigned less(Lanes a, Lanes b) noexcept {
    return static_cast<unsigned>(_mm256_movemask_ps(_mm256_cmp_ps(a.lane, b.lane, _CMP_LT_OQ)));
}

COPPICE_LANES unsigned bits_less_equal(Lanes a, Lanes b) noexcept {
    const __m256i is_greater =
        _mm256_cmpgt_epi32(_mm256_castps_si256(a.lane), _mm256_castps_si256(b.lane));
    return static_cast<unsigned>(_mm256_movemask_ps(_mm256_castsi256_ps(is_greater))) ^ 0xffU;
}

}  // namespace coppice::inline v0::simd::avx2

COPPICE_TARGET_END

#endif
