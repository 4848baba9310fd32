// Lanes in a 256-bit register, with AVX2 and FMA: the common part of lanes_avx2.h and
// lanes_avx512.h. lanes_scalar.h documents the operations.
#pragma once

#include "simd/doubles_256.h"
#include "simd/registers_256.h"
#include "simd/target.h"

#if defined(__x86_64__)

#include <immintrin.h>

#include <array>
#include <cstddef>
#include <cstdint>

COPPICE_TARGET_AVX2

namespace coppice::inline v0::simd::wide256 {

COPPICE_LANES Lanes load(const std::array<float, 8>& from) noexcept {
    return {_mm256_load_ps(from.data())};
}

COPPICE_LANES void store(Lanes lanes, std::array<float, 8>& to) noexcept {
    _mm256_store_ps(to.data(), lanes.lane);
}

COPPICE_LANES Lanes load_unaligned(const float* from) noexcept {
    return {_mm256_loadu_ps(from)};
}

COPPICE_LANES void store_unaligned(Lanes lanes, float* to) noexcept {
    _mm256_storeu_ps(to, lanes.lane);
}

COPPICE_LANES Lanes broadcast(float value) noexcept {
    return {_mm256_set1_ps(value)};
}

COPPICE_LANES Lanes operator/(Lanes a, Lanes b) noexcept {
    return {_mm256_div_ps(a.lane, b.lane)};
}

// a * b - c, rounded once.
COPPICE_LANES Lanes multiply_subtract(Lanes a, Lanes b, Lanes c) noexcept {
    return {_mm256_fmsub_ps(a.lane, b.lane, c.lane)};
}

// a - b * c, rounded once.
COPPICE_LANES Lanes subtract_product(Lanes a, Lanes b, Lanes c) noexcept {
    return {_mm256_fnmadd_ps(b.lane, c.lane, a.lane)};
}

COPPICE_LANES Lanes min(Lanes a, Lanes b) noexcept {
    return {_mm256_min_ps(a.lane, b.lane)};
}

COPPICE_LANES Lanes max(Lanes a, Lanes b) noexcept {
    return {_mm256_max_ps(a.lane, b.lane)};
}

COPPICE_LANES Lanes abs(Lanes a) noexcept {
    return {_mm256_andnot_ps(_mm256_set1_ps(-0.0F), a.lane)};
}

COPPICE_LANES Lanes bits_max(Lanes a, Lanes b) noexcept {
    return {_mm256_castsi256_ps(
        _mm256_max_epi32(_mm256_castps_si256(a.lane), _mm256_castps_si256(b.lane)))};
}

COPPICE_LANES Lanes bits_min(Lanes a, Lanes b) noexcept {
    return {_mm256_castsi256_ps(
        _mm256_min_epi32(_mm256_castps_si256(a.lane), _mm256_castps_si256(b.lane)))};
}

COPPICE_LANES Lanes truncate(Lanes a) noexcept {
    return {_mm256_cvtepi32_ps(_mm256_cvttps_epi32(a.lane))};
}

COPPICE_LANES void store_integers(Lanes lanes, std::array<std::int32_t, 8>& to) noexcept {
    _mm256_store_si256(reinterpret_cast<__m256i*>(to.data()), _mm256_cvttps_epi32(lanes.lane));
}

COPPICE_LANES Lanes swap_halves(Lanes a) noexcept {
    return {_mm256_permute2f128_ps(a.lane, a.lane, 1)};
}

COPPICE_LANES Lanes with_lane(Lanes lanes, std::size_t lane, float value) noexcept {
    const __m256i numbers = _mm256_setr_epi32(0, 1, 2, 3, 4, 5, 6, 7);
    const __m256i is_it = _mm256_cmpeq_epi32(numbers, _mm256_set1_epi32(static_cast<int>(lane)));
    return {_mm256_blendv_ps(lanes.lane, _mm256_set1_ps(value), _mm256_castsi256_ps(is_it))};
}

COPPICE_LANES Lanes choose(bool is_first, Lanes first, Lanes second) noexcept {
    const __m256i mask = _mm256_set1_epi32(is_first ? -1 : 0);
    return {_mm256_blendv_ps(second.lane, first.lane, _mm256_castsi256_ps(mask))};
}

COPPICE_LANES Quad make_quad(float a, float b, float c, float d) noexcept {
    return {_mm_setr_ps(a, b, c, d)};
}

COPPICE_LANES Quad load_point(const float* point) noexcept {
    return {_mm_maskload_ps(point, _mm_setr_epi32(-1, -1, -1, 0))};
}

COPPICE_LANES Quad lower_half(Lanes a) noexcept {
    return {_mm256_castps256_ps128(a.lane)};
}

COPPICE_LANES Quad upper_half(Lanes a) noexcept {
    return {_mm256_extractf128_ps(a.lane, 1)};
}

COPPICE_LANES Lanes join(Quad lower, Quad upper) noexcept {
    return {_mm256_set_m128(upper.lane, lower.lane)};
}

COPPICE_LANES Quad min(Quad a, Quad b) noexcept {
    return {_mm_min_ps(a.lane, b.lane)};
}

COPPICE_LANES unsigned greater_equal(Quad a, Quad b) noexcept {
    return static_cast<unsigned>(_mm_movemask_ps(_mm_cmpge_ps(a.lane, b.lane)));
}

COPPICE_LANES Quad of_next_axis(Quad a) noexcept {
    return {_mm_shuffle_ps(a.lane, a.lane, _MM_SHUFFLE(3, 0, 2, 1))};
}

COPPICE_LANES float sum_of_axes(Quad a) noexcept {
    const __m128 x_and_y = _mm_add_ss(a.lane, _mm_movehdup_ps(a.lane));
    return _mm_cvtss_f32(_mm_add_ss(x_and_y, _mm_movehl_ps(a.lane, a.lane)));
}

COPPICE_LANES std::array<std::uint32_t, 3> to_integers(Quad a) noexcept {
    const __m128i integers = _mm_cvttps_epi32(a.lane);
    const auto low = static_cast<std::uint64_t>(_mm_cvtsi128_si64(integers));
    return {static_cast<std::uint32_t>(low), static_cast<std::uint32_t>(low >> 32U),
            static_cast<std::uint32_t>(_mm_extract_epi32(integers, 2))};
}

COPPICE_LANES std::array<Lanes, 3> load_points(const std::array<const float*, 8>& points) noexcept {
    const auto pair = [&](std::size_t lane) {  // lanes `lane` and `lane + 4`, one in each half
        return join(load_point(points[lane]), load_point(points[lane + 4])).lane;
    };
    const __m256 a = pair(0);
    const __m256 b = pair(1);
    const __m256 c = pair(2);
    const __m256 d = pair(3);
    const __m256 ab_xy = _mm256_unpacklo_ps(a, b);
    const __m256 cd_xy = _mm256_unpacklo_ps(c, d);
    const __m256 ab_z = _mm256_unpackhi_ps(a, b);
    const __m256 cd_z = _mm256_unpackhi_ps(c, d);
    return {Lanes{_mm256_shuffle_ps(ab_xy, cd_xy, _MM_SHUFFLE(1, 0, 1, 0))},
            Lanes{_mm256_shuffle_ps(ab_xy, cd_xy, _MM_SHUFFLE(3, 2, 3, 2))},
            Lanes{_mm256_shuffle_ps(ab_z, cd_z, _MM_SHUFFLE(1, 0, 1, 0))}};
}

COPPICE_LANES Mask operator&(Mask a, Mask b) noexcept {
    return {_mm256_and_ps(a.lane, b.lane)};
}

COPPICE_LANES Lanes select(Mask mask, Lanes first, Lanes second) noexcept {
    return {_mm256_blendv_ps(second.lane, first.lane, mask.lane)};
}

COPPICE_LANES Lanes keep(Mask mask, Lanes lanes) noexcept {
    return {_mm256_and_ps(mask.lane, lanes.lane)};
}

struct Counters {
    __m256i lane;
};

COPPICE_LANES Counters make_counters() noexcept {
    return {_mm256_setzero_si256()};
}

COPPICE_LANES void count(Counters& counters, Mask mask) noexcept {
    counters.lane = _mm256_sub_epi32(counters.lane, _mm256_castps_si256(mask.lane));
}

COPPICE_LANES Lanes to_lanes(Counters counters) noexcept {
    return {_mm256_cvtepi32_ps(counters.lane)};
}

COPPICE_LANES Doubles to_doubles(Quad a) noexcept {
    return {_mm256_cvtps_pd(a.lane)};
}

}  // namespace coppice::inline v0::simd::wide256

COPPICE_TARGET_END

#endif
