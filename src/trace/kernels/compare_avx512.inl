// Lanes compared, and sizes, in one instruction each. Part of a kernel source, included after
// lanes_avx2.inl; the twin of compare_avx2.inl.

inline Lanes larger_size(Lanes a, Lanes b) noexcept {
    constexpr int larger_without_signs = 0b1011;
    return {_mm256_range_ps(a.lane, b.lane, larger_without_signs)};
}

inline unsigned less_equal(Lanes a, Lanes b) noexcept {
    return _mm256_cmp_ps_mask(a.lane, b.lane, _CMP_LE_OQ);
}

inline unsigned less(Lanes a, Lanes b) noexcept {
    return _mm256_cmp_ps_mask(a.lane, b.lane, _CMP_LT_OQ);
}

inline unsigned bits_less_equal(Lanes a, Lanes b) noexcept {
    return _mm256_cmple_epi32_mask(_mm256_castps_si256(a.lane), _mm256_castps_si256(b.lane));
}
