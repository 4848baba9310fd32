// Eight lanes in a 256-bit register. Part of a kernel source; the twin of lanes_scalar.inl.

using Lanes = __m256;  // which has +, - and *

inline Lanes load(const float* from) noexcept {
    return _mm256_loadu_ps(from);
}

inline void store(Lanes lanes, float* to) noexcept {
    _mm256_storeu_ps(to, lanes);
}

inline Lanes max(Lanes a, Lanes b) noexcept {
    return _mm256_max_ps(a, b);
}

inline Lanes min(Lanes a, Lanes b) noexcept {
    return _mm256_min_ps(a, b);
}

inline Lanes broadcast(float value) noexcept {
    return _mm256_set1_ps(value);
}

inline Lanes swap_halves(Lanes lanes) noexcept {
    return _mm256_permute2f128_ps(lanes, lanes, 1);
}

inline Lanes with_lane(Lanes lanes, std::size_t lane, float value) noexcept {
    const __m256i numbers = _mm256_setr_epi32(0, 1, 2, 3, 4, 5, 6, 7);
    const __m256i is_it = _mm256_cmpeq_epi32(numbers, _mm256_set1_epi32(static_cast<int>(lane)));
    return _mm256_blendv_ps(lanes, broadcast(value), _mm256_castsi256_ps(is_it));
}

inline bool has_extent(Lanes box) noexcept {
    const __m128 extent = _mm_add_ps(_mm256_castps256_ps128(box), _mm256_extractf128_ps(box, 1));
    return (_mm_movemask_ps(_mm_cmpge_ps(extent, _mm_setzero_ps())) & 7) == 7;
}

inline Lanes only_if(bool condition, Lanes lanes) noexcept {
    const __m256i mask = _mm256_set1_epi32(condition ? -1 : 0);
    return _mm256_blendv_ps(_mm256_set1_ps(-std::numeric_limits<float>::infinity()), lanes,
                            _mm256_castsi256_ps(mask));
}

inline __m128 sum_of(Lanes prim_ref) noexcept {
    return _mm_sub_ps(_mm256_extractf128_ps(prim_ref, 1), _mm256_castps256_ps128(prim_ref));
}

inline Lanes centroid_of(Lanes prim_ref) noexcept {
    const __m128 sum = sum_of(prim_ref);
    return _mm256_set_m128(sum, _mm_xor_ps(sum, _mm_set1_ps(-0.0F)));
}

struct BinLanes {
    std::array<std::uint32_t, 3> index;
};

class Binner {
public:
    explicit Binner(const BinMapping& mapping) noexcept
        : origin_(_mm_setr_ps(mapping.origin[0], mapping.origin[1], mapping.origin[2], 0.0F)),
          scale_(_mm_setr_ps(mapping.scale[0], mapping.scale[1], mapping.scale[2], 0.0F)),
          last_(_mm_set1_ps(static_cast<float>(mapping.bin_count - 1))) {}

    [[nodiscard]] BinLanes operator()(Lanes prim_ref) const noexcept {
        const __m128 place = _mm_mul_ps(_mm_sub_ps(sum_of(prim_ref), origin_), scale_);
        const __m128i bin = _mm_cvttps_epi32(_mm_min_ps(place, last_));  // last_ for NaN
        const auto low = static_cast<std::uint64_t>(_mm_cvtsi128_si64(bin));
        return {{static_cast<std::uint32_t>(low), static_cast<std::uint32_t>(low >> 32U),
                 static_cast<std::uint32_t>(_mm_extract_epi32(bin, 2))}};
    }

private:
    __m128 origin_;
    __m128 scale_;
    __m128 last_;
};

inline float half_area(Lanes box, float factor) noexcept {
    const __m128 extent =
        _mm_mul_ps(_mm_add_ps(_mm256_extractf128_ps(box, 1), _mm256_castps256_ps128(box)),
                   _mm_set1_ps(factor));
    const __m128 next = _mm_shuffle_ps(extent, extent, _MM_SHUFFLE(3, 0, 2, 1));
    const __m128 product = _mm_mul_ps(extent, next);  // xy, yz, zx
    const __m128 xy_yz = _mm_add_ss(product, _mm_movehdup_ps(product));
    return _mm_cvtss_f32(_mm_add_ss(xy_yz, _mm_movehl_ps(product, product)));
}

// x, y and z of a point, and nothing beyond: it may be the last of its array.
inline __m128 load_point(const Vec3f* point) noexcept {
    return _mm_maskload_ps(&point->x, _mm_setr_epi32(-1, -1, -1, 0));
}

inline Lanes lanes_of(const Vec3f& point) noexcept {
    const __m128 coordinates = load_point(&point);
    return _mm256_set_m128(coordinates, _mm_xor_ps(coordinates, _mm_set1_ps(-0.0F)));
}

inline void transpose(const std::array<const Vec3f*, 8>& points,
                      std::array<std::array<float, 8>, 3>& axes) noexcept {
    const auto pair = [&](std::size_t lane) {  // lane and lane + 4, a half each
        return _mm256_set_m128(load_point(points[lane + 4]), load_point(points[lane]));
    };
    const __m256 a = pair(0);
    const __m256 b = pair(1);
    const __m256 c = pair(2);
    const __m256 d = pair(3);
    const __m256 ab_xy = _mm256_unpacklo_ps(a, b);
    const __m256 cd_xy = _mm256_unpacklo_ps(c, d);
    const __m256 ab_z = _mm256_unpackhi_ps(a, b);
    const __m256 cd_z = _mm256_unpackhi_ps(c, d);
    _mm256_storeu_ps(axes[0].data(), _mm256_shuffle_ps(ab_xy, cd_xy, _MM_SHUFFLE(1, 0, 1, 0)));
    _mm256_storeu_ps(axes[1].data(), _mm256_shuffle_ps(ab_xy, cd_xy, _MM_SHUFFLE(3, 2, 3, 2)));
    _mm256_storeu_ps(axes[2].data(), _mm256_shuffle_ps(ab_z, cd_z, _MM_SHUFFLE(1, 0, 1, 0)));
}
