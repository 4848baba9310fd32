// Eight lanes of floats in a 256-bit register. Part of a kernel source; the twin of
// lanes_scalar.inl.

struct Lanes {
    __m256 lane;
};

inline Lanes load(const std::array<float, 8>& from) noexcept {
    return {_mm256_load_ps(from.data())};
}

inline void store(Lanes lanes, std::array<float, 8>& to) noexcept {
    _mm256_store_ps(to.data(), lanes.lane);
}

inline Lanes broadcast(float value) noexcept {
    return {_mm256_set1_ps(value)};
}

inline Lanes operator+(Lanes a, Lanes b) noexcept {
    return {_mm256_add_ps(a.lane, b.lane)};
}

inline Lanes operator-(Lanes a, Lanes b) noexcept {
    return {_mm256_sub_ps(a.lane, b.lane)};
}

inline Lanes operator*(Lanes a, Lanes b) noexcept {
    return {_mm256_mul_ps(a.lane, b.lane)};
}

inline Lanes operator/(Lanes a, Lanes b) noexcept {
    return {_mm256_div_ps(a.lane, b.lane)};
}

// a * b - c, rounded once.
inline Lanes multiply_subtract(Lanes a, Lanes b, Lanes c) noexcept {
    return {_mm256_fmsub_ps(a.lane, b.lane, c.lane)};
}

// a - b * c, rounded once.
inline Lanes subtract_product(Lanes a, Lanes b, Lanes c) noexcept {
    return {_mm256_fnmadd_ps(b.lane, c.lane, a.lane)};
}

inline Lanes min(Lanes a, Lanes b) noexcept {
    return {_mm256_min_ps(a.lane, b.lane)};
}

inline Lanes max(Lanes a, Lanes b) noexcept {
    return {_mm256_max_ps(a.lane, b.lane)};
}

inline Lanes abs(Lanes a) noexcept {
    return {_mm256_andnot_ps(_mm256_set1_ps(-0.0F), a.lane)};
}

inline unsigned less_equal(Lanes a, Lanes b) noexcept {
    return static_cast<unsigned>(_mm256_movemask_ps(_mm256_cmp_ps(a.lane, b.lane, _CMP_LE_OQ)));
}

inline unsigned less(Lanes a, Lanes b) noexcept {
    return static_cast<unsigned>(_mm256_movemask_ps(_mm256_cmp_ps(a.lane, b.lane, _CMP_LT_OQ)));
}

// For each mask the places of its bits, then zeros, a byte each.
constexpr std::array<std::uint64_t, 256> selections = [] {
    std::array<std::uint64_t, 256> all{};
    for (unsigned mask = 0; mask < 256; ++mask) {
        unsigned shift = 0;
        for (std::uint64_t place = 0; place < 8; ++place) {
            if ((mask >> place & 1U) == 0) continue;
            all[mask] |= place << shift;
            shift += 8;
        }
    }
    return all;
}();

inline __m256i selection_of(unsigned mask) noexcept {
    return _mm256_cvtepu8_epi32(_mm_cvtsi64_si128(static_cast<long long>(selections[mask])));
}

// Stores eight values, those of the lanes in the mask first.
inline void store_selected(unsigned mask, Lanes from, float* to) noexcept {
    _mm256_storeu_ps(to, _mm256_permutevar8x32_ps(from.lane, selection_of(mask)));
}

template <typename T>
inline void store_selected(unsigned mask, const std::array<T, 8>& from, T* to) noexcept {
    static_assert(sizeof(T) == 4);
    const __m256i all = _mm256_load_si256(reinterpret_cast<const __m256i*>(from.data()));
    _mm256_storeu_si256(reinterpret_cast<__m256i*>(to),
                        _mm256_permutevar8x32_epi32(all, selection_of(mask)));
}

// The lane in the mask, which is not 0, with the least value up to 7 units in the last place; values are not negative.
inline std::size_t nearest_of(Lanes values, unsigned mask) noexcept {
    const __m256i lanes = _mm256_setr_epi32(0, 1, 2, 3, 4, 5, 6, 7);
    const __m256i bits = _mm256_setr_epi32(1, 2, 4, 8, 16, 32, 64, 128);
    const __m256i is_in = _mm256_cmpeq_epi32(
        _mm256_and_si256(_mm256_set1_epi32(static_cast<int>(mask)), bits), bits);
    const __m256i key = _mm256_or_si256(
        _mm256_andnot_si256(_mm256_set1_epi32(7), _mm256_castps_si256(values.lane)), lanes);
    const __m256i all = _mm256_or_si256(key, _mm256_andnot_si256(is_in, _mm256_set1_epi32(-8)));
    __m128i least = _mm_min_epu32(_mm256_castsi256_si128(all), _mm256_extracti128_si256(all, 1));
    least = _mm_min_epu32(least, _mm_shuffle_epi32(least, 0x4e));
    least = _mm_min_epu32(least, _mm_shuffle_epi32(least, 0xb1));
    return static_cast<std::size_t>(_mm_cvtsi128_si32(least) & 7);
}
