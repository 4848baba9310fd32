// One triangle of a block decided in double precision, its three corners at a time: the very
// operations of TriangleTest, so the very same bits. Part of a kernel source; the twin of
// decide_scalar.inl.

// A value of the three corners a, b, c; the fourth lane is that of c again.
struct ByCorner {
    __m256d lane;
};

inline ByCorner operator-(ByCorner a, ByCorner b) noexcept {
    return {_mm256_sub_pd(a.lane, b.lane)};
}

inline ByCorner operator*(ByCorner a, ByCorner b) noexcept {
    return {_mm256_mul_pd(a.lane, b.lane)};
}

inline ByCorner of_all(double value) noexcept {
    return {_mm256_set1_pd(value)};
}

// (a, b, c) becomes (c, a, b).
inline ByCorner of_previous(ByCorner v) noexcept {
    return {_mm256_permute4x64_pd(v.lane, _MM_SHUFFLE(1, 1, 0, 2))};
}

// (a, b, c) becomes (b, c, a).
inline ByCorner of_next(ByCorner v) noexcept {
    return {_mm256_permute4x64_pd(v.lane, _MM_SHUFFLE(0, 0, 2, 1))};
}

inline std::array<double, 4> to_array(ByCorner v) noexcept {
    alignas(32) std::array<double, 4> values;
    _mm256_store_pd(values.data(), v.lane);
    return values;
}

inline ByCorner size_of(ByCorner v) noexcept {
    return {_mm256_andnot_pd(_mm256_set1_pd(-0.0), v.lane)};
}

inline ByCorner larger(ByCorner a, ByCorner b) noexcept {
    return {_mm256_max_pd(a.lane, b.lane)};
}

inline double greatest(ByCorner v) noexcept {
    const __m128d pairs =
        _mm_max_pd(_mm256_castpd256_pd128(v.lane), _mm256_extractf128_pd(v.lane, 1));
    return _mm_cvtsd_f64(_mm_max_sd(pairs, _mm_unpackhi_pd(pairs, pairs)));
}

inline double range_of(ByCorner v) noexcept {
    const ByCorner negated{_mm256_xor_pd(_mm256_set1_pd(-0.0), v.lane)};
    return greatest(v) + greatest(negated);
}

// One coordinate of the corners.
inline ByCorner coordinate(const TriangleBlock& block, std::size_t lane,
                           std::size_t axis) noexcept {
    const float c = block.corner[2][axis][lane];
    return {_mm256_cvtps_pd(
        _mm_setr_ps(block.corner[0][axis][lane], block.corner[1][axis][lane], c, c))};
}

// The component of the cross product of b - a and c - a that two of their coordinates give.
inline double cross_component(ByCorner y, ByCorner z) noexcept {
    const auto from_a = [](ByCorner v) {
        return v - ByCorner{_mm256_permute4x64_pd(v.lane, _MM_SHUFFLE(0, 0, 0, 0))};
    };
    const ByCorner products =
        from_a(y) * ByCorner{_mm256_permute4x64_pd(from_a(z).lane, _MM_SHUFFLE(3, 1, 2, 0))};
    const __m128d low = _mm256_castpd256_pd128(products.lane);
    const __m128d of_b = _mm_unpackhi_pd(low, low);
    return _mm_cvtsd_f64(_mm_sub_sd(of_b, _mm256_extractf128_pd(products.lane, 1)));
}

inline Vec3f normal_of(ByCorner x, ByCorner y, ByCorner z, const RayAxes& axes) noexcept {
    std::array<float, 3> n;
    n[axes.x] = static_cast<float>(cross_component(y, z));
    n[axes.y] = static_cast<float>(cross_component(z, x));
    n[axes.z] = static_cast<float>(cross_component(x, y));
    return {n[0], n[1], n[2]};
}

// True if the ray hits the triangle at a t of at most t_max, and then the hit.
inline bool decide(const TriangleBlock& block, std::size_t lane, const Ray& ray,
                   const RayAxes& axes, float t_max, Hit& hit) noexcept {
    const auto of = [](Vec3f v, std::size_t axis) {
        return double{std::array<float, 3>{v.x, v.y, v.z}[axis]};
    };
    const double scale_z = 1.0 / of(ray.direction, axes.z);
    const ByCorner raw_x = coordinate(block, lane, axes.x);
    const ByCorner raw_y = coordinate(block, lane, axes.y);
    const ByCorner raw_z = coordinate(block, lane, axes.z);
    const ByCorner z = raw_z - of_all(of(ray.origin, axes.z));
    const ByCorner x =
        (raw_x - of_all(of(ray.origin, axes.x))) - of_all(of(ray.direction, axes.x) * scale_z) * z;
    const ByCorner y =
        (raw_y - of_all(of(ray.origin, axes.y))) - of_all(of(ray.direction, axes.y) * scale_z) * z;

    const ByCorner weight = of_previous(x) * of_next(y) - of_previous(y) * of_next(x);
    const FrameExtent extent{greatest(larger(size_of(x), size_of(y))), greatest(size_of(z))};
    const double error = weight_error(extent);
    const auto w = to_array(weight);
    const double least = std::min(w[0], std::min(w[1], w[2]));
    const double most = std::max(w[0], std::max(w[1], w[2]));
    if (least < -error && most > error) return false;
    const auto part = to_array(weight * z);
    const double sum = w[0] + w[1] + w[2];
    const double mean = (part[0] + part[1] + part[2]) / sum;
    const bool is_certain =
        (least > error || most < -error) && is_precise(mean, sum, range_of(z), extent);
    if (!is_certain) return decide_alone(block, lane, ray, t_max, hit);

    const auto t = static_cast<float>(mean * scale_z);
    if (!(t >= ray.t_min && t <= t_max && t <= std::numeric_limits<float>::max())) return false;
    const double per_weight = 1.0 / sum;
    // One by one: a temporary would be copied in pieces that are not those it was written in.
    hit.t = t;
    hit.u = static_cast<float>(w[1] * per_weight);
    hit.v = static_cast<float>(w[2] * per_weight);
    hit.prim = block.id[lane];
    hit.normal = normal_of(raw_x, raw_y, raw_z, axes);
    return true;
}
