// Lanes in two 128-bit registers, with SSE4.2. Only the operations of lanes_scalar.h that ray
// traversal uses.
#pragma once

#include "simd/target.h"

#if defined(__x86_64__)

#include <immintrin.h>

#include <array>

COPPICE_TARGET_SSE42

namespace coppice::inline v0::simd::sse42 {

struct Lanes {
    __m128 low;
    __m128 high;
};

COPPICE_LANES Lanes load(const std::array<float, 8>& from) noexcept {
    return {_mm_load_ps(from.data()), _mm_load_ps(from.data() + 4)};
}

COPPICE_LANES void store(Lanes lanes, std::array<float, 8>& to) noexcept {
    _mm_store_ps(to.data(), lanes.low);
    _mm_store_ps(to.data() + 4, lanes.high);
}

COPPICE_LANES Lanes broadcast(float value) noexcept {
    return {_mm_set1_ps(value), _mm_set1_ps(value)};
}

COPPICE_LANES Lanes operator+(Lanes a, Lanes b) noexcept {
    return {_mm_add_ps(a.low, b.low), _mm_add_ps(a.high, b.high)};
}

COPPICE_LANES Lanes operator-(Lanes a, Lanes b) noexcept {
    return {_mm_sub_ps(a.low, b.low), _mm_sub_ps(a.high, b.high)};
}

COPPICE_LANES Lanes operator*(Lanes a, Lanes b) noexcept {
    return {_mm_mul_ps(a.low, b.low), _mm_mul_ps(a.high, b.high)};
}

COPPICE_LANES Lanes operator/(Lanes a, Lanes b) noexcept {
    return {_mm_div_ps(a.low, b.low), _mm_div_ps(a.high, b.high)};
}

// a * b - c, rounded twice.
COPPICE_LANES Lanes multiply_subtract(Lanes a, Lanes b, Lanes c) noexcept {
    return a * b - c;
}

// a - b * c, rounded twice.
COPPICE_LANES Lanes subtract_product(Lanes a, Lanes b, Lanes c) noexcept {
    return a - b * c;
}

COPPICE_LANES Lanes min(Lanes a, Lanes b) noexcept {
    return {_mm_min_ps(a.low, b.low), _mm_min_ps(a.high, b.high)};
}

COPPICE_LANES Lanes max(Lanes a, Lanes b) noexcept {
    return {_mm_max_ps(a.low, b.low), _mm_max_ps(a.high, b.high)};
}

COPPICE_LANES Lanes abs(Lanes a) noexcept {
    const __m128 sign = _mm_set1_ps(-0.0F);
    return {_mm_andnot_ps(sign, a.low), _mm_andnot_ps(sign, a.high)};
}

// The larger of two absolute values.
COPPICE_LANES Lanes larger_size(Lanes a, Lanes b) noexcept {
    return max(abs(a), abs(b));
}

// A bit for every lane with a negative sign.
COPPICE_LANES unsigned signs_of(__m128 low, __m128 high) noexcept {
    return static_cast<unsigned>(_mm_movemask_ps(low) | _mm_movemask_ps(high) << 4);
}

COPPICE_LANES unsigned less_equal(Lanes a, Lanes b) noexcept {
    return signs_of(_mm_cmple_ps(a.low, b.low), _mm_cmple_ps(a.high, b.high));
}

COPPICE_LANES unsigned less(Lanes a, Lanes b) noexcept {
    return signs_of(_mm_cmplt_ps(a.low, b.low), _mm_cmplt_ps(a.high, b.high));
}

COPPICE_LANES Lanes bits_max(Lanes a, Lanes b) noexcept {
    const auto larger = [](__m128 x, __m128 y) {
        return _mm_castsi128_ps(_mm_max_epi32(_mm_castps_si128(x), _mm_castps_si128(y)));
    };
    return {larger(a.low, b.low), larger(a.high, b.high)};
}

COPPICE_LANES Lanes bits_min(Lanes a, Lanes b) noexcept {
    const auto smaller = [](__m128 x, __m128 y) {
        return _mm_castsi128_ps(_mm_min_epi32(_mm_castps_si128(x), _mm_castps_si128(y)));
    };
    return {smaller(a.low, b.low), smaller(a.high, b.high)};
}

COPPICE_LANES unsigned bits_less_equal(Lanes a, Lanes b) noexcept {
    const auto is_greater = [](__m128 x, __m128 y) {
        return _mm_castsi128_ps(_mm_cmpgt_epi32(_mm_castps_si128(x), _mm_castps_si128(y)));
    };
    return signs_of(is_greater(a.low, b.low), is_greater(a.high, b.high)) ^ 0xffU;
}

}  // namespace coppice::inline v0::simd::sse42

COPPICE_TARGET_END

#endif
