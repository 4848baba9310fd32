// Registers of AVX2 and their arithmetic; a part of lanes_256.h.
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

}  // namespace coppice::inline v0::simd::wide256

COPPICE_TARGET_END

#endif
