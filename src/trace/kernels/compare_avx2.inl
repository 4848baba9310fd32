// Lanes compared, and sizes, as AVX2 does it. Part of a kernel source, included after
// lanes_avx2.inl.

// The larger of two without their signs.
inline Lanes larger_size(Lanes a, Lanes b) noexcept {
    return max(abs(a), abs(b));
}

inline unsigned less_equal(Lanes a, Lanes b) noexcept {
    return static_cast<unsigned>(_mm256_movemask_ps(_mm256_cmp_ps(a.lane, b.lane, _CMP_LE_OQ)));
}

inline unsigned less(Lanes a, Lanes b) noexcept {
    return static_cast<unsigned>(_mm256_movemask_ps(_mm256_cmp_ps(a.lane, b.lane, _CMP_LT_OQ)));
}

inline unsigned bits_less_equal(Lanes a, Lanes b) noexcept {
    const __m256i is_greater =
        _mm256_cmpgt_epi32(_mm256_castps_si256(a.lane), _mm256_castps_si256(b.lane));
    return static_cast<unsigned>(_mm256_movemask_ps(_mm256_castsi256_ps(is_greater))) ^ 0xffU;
}
