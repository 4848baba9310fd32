// Four doubles in a 256-bit register, with AVX2. Included by lanes_256.h.
#pragma once

#include "simd/registers_256.h"
#include "simd/target.h"

#if defined(__x86_64__)

#include <immintrin.h>

#include <cstddef>

COPPICE_TARGET_AVX2

namespace coppice::inline v0::simd::wide256 {

COPPICE_LANES void store(Doubles doubles, double* to) noexcept {
    _mm256_store_pd(to, doubles.lane);
}

COPPICE_LANES Doubles broadcast_double(double value) noexcept {
    return {_mm256_set1_pd(value)};
}

COPPICE_LANES Doubles max(Doubles a, Doubles b) noexcept {
    return {_mm256_max_pd(a.lane, b.lane)};
}

COPPICE_LANES Doubles abs(Doubles a) noexcept {
    return {_mm256_andnot_pd(_mm256_set1_pd(-0.0), a.lane)};
}

template <std::size_t i, std::size_t j, std::size_t k, std::size_t l>
COPPICE_LANES Doubles permute(Doubles a) noexcept {
    return {_mm256_permute4x64_pd(a.lane, _MM_SHUFFLE(l, k, j, i))};
}

template <std::size_t i>
COPPICE_LANES double get(Doubles a) noexcept {
    const __m128d half = i < 2 ? _mm256_castpd256_pd128(a.lane) : _mm256_extractf128_pd(a.lane, 1);
    return _mm_cvtsd_f64(i % 2 == 0 ? half : _mm_unpackhi_pd(half, half));
}

COPPICE_LANES double greatest(Doubles a) noexcept {
    const __m128d pairs =
        _mm_max_pd(_mm256_castpd256_pd128(a.lane), _mm256_extractf128_pd(a.lane, 1));
    return _mm_cvtsd_f64(_mm_max_sd(pairs, _mm_unpackhi_pd(pairs, pairs)));
}

COPPICE_LANES unsigned less_equal(Doubles a, Doubles b) noexcept {
    return static_cast<unsigned>(_mm256_movemask_pd(_mm256_cmp_pd(a.lane, b.lane, _CMP_LE_OQ)));
}

COPPICE_LANES DoubleMask operator&(DoubleMask a, DoubleMask b) noexcept {
    return {_mm256_and_pd(a.lane, b.lane)};
}

COPPICE_LANES DoubleMask operator|(DoubleMask a, DoubleMask b) noexcept {
    return {_mm256_or_pd(a.lane, b.lane)};
}

COPPICE_LANES Doubles select(DoubleMask mask, Doubles first, Doubles second) noexcept {
    return {_mm256_blendv_pd(second.lane, first.lane, mask.lane)};
}

}  // namespace coppice::inline v0::simd::wide256

COPPICE_TARGET_END

#endif
