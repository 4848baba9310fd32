// Eight lanes of floats in a 256-bit register. Part of a kernel source; with a compare_*.inl the
// twin of lanes_scalar.inl.

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

// The larger and the smaller of two, and which of a is not above b (bits_less_equal), compared as
// integers: one cycle instead of four. That is the order of floats but for NaN and two that are
// both negative (or -0).
inline Lanes bits_max(Lanes a, Lanes b) noexcept {
    return {_mm256_castsi256_ps(
        _mm256_max_epi32(_mm256_castps_si256(a.lane), _mm256_castps_si256(b.lane)))};
}

inline Lanes bits_min(Lanes a, Lanes b) noexcept {
    return {_mm256_castsi256_ps(
        _mm256_min_epi32(_mm256_castps_si256(a.lane), _mm256_castps_si256(b.lane)))};
}
