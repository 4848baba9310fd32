// AVX2 registers and their arithmetic. Included by lanes_256.h.
#pragma once

#include "simd/target.h"

#if defined(__x86_64__)

#include <immintrin.h>

#include <type_traits>

COPPICE_TARGET_AVX2

namespace coppice::inline v0::simd::wide256 {

struct Lanes {
    __m256 lane;
};

struct Quad {
    __m128 lane;
};

struct Doubles {
    __m256d lane;
};

struct Mask {
    __m256 lane;
};

struct DoubleMask {
    __m256d lane;
};

template <typename T>
concept Register =
    std::is_same_v<T, Lanes> || std::is_same_v<T, Quad> || std::is_same_v<T, Doubles>;

template <Register T>
COPPICE_LANES T operator+(T a, T b) noexcept {
    return {a.lane + b.lane};
}

template <Register T>
COPPICE_LANES T operator-(T a, T b) noexcept {
    return {a.lane - b.lane};
}

template <Register T>
COPPICE_LANES T operator*(T a, T b) noexcept {
    return {a.lane * b.lane};
}

template <Register T>
COPPICE_LANES T operator-(T a) noexcept {
    return {-a.lane};
}

template <int predicate>
COPPICE_LANES Mask compare(Lanes a, Lanes b) noexcept {
    return {_mm256_cmp_ps(a.lane, b.lane, predicate)};
}

template <int predicate>
COPPICE_LANES DoubleMask compare(Doubles a, Doubles b) noexcept {
    return {_mm256_cmp_pd(a.lane, b.lane, predicate)};
}

template <Register T>
COPPICE_LANES auto is_less(T a, T b) noexcept {
    return compare<_CMP_LT_OQ>(a, b);
}

template <Register T>
COPPICE_LANES auto is_equal(T a, T b) noexcept {
    return compare<_CMP_EQ_OQ>(a, b);
}

}  // namespace coppice::inline v0::simd::wide256

COPPICE_TARGET_END

#endif
