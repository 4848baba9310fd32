// Decides one triangle of a block in double precision, with exactly the operations of TriangleTest
// and hence the same bits. With registers of four doubles, the three corners are processed at once.

#include "simd/set.h"

#if defined(COPPICE_TRACE_KERNELS_DECIDE_H) == defined(COPPICE_SIMD_TOGGLE)
#ifdef COPPICE_SIMD_TOGGLE
#undef COPPICE_TRACE_KERNELS_DECIDE_H
#else
#define COPPICE_TRACE_KERNELS_DECIDE_H
#endif

#include "coppice/geom/ray.h"
#include "coppice/geom/triangle.h"
#include "coppice/tree/bvh8.h"

#include "geom/triangle_error.h"
#include "trace/kernels/bvh8_trace.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>

#include COPPICE_SIMD_LANES

COPPICE_SIMD_BEGIN

namespace coppice::inline v0 {
namespace {
namespace COPPICE_SIMD_SET {

using namespace simd::COPPICE_SIMD_SET;

#if COPPICE_SIMD_ISA >= COPPICE_SIMD_AVX2

// One value for each of the corners a, b, c; the fourth lane repeats c.
using ByCorner = Doubles;

// (a, b, c) becomes (c, a, b).
inline ByCorner of_previous(ByCorner v) noexcept {
    return permute<2, 0, 1, 1>(v);
}

// (a, b, c) becomes (b, c, a).
inline ByCorner of_next(ByCorner v) noexcept {
    return permute<1, 2, 0, 0>(v);
}

inline std::array<double, 4> to_array(ByCorner v) noexcept {
    alignas(32) std::array<double, 4> values;
    store(v, values.data());
    return values;
}

// One coordinate of all corners.
inline ByCorner coordinate(const TriangleBlock& block, std::size_t lane,
                           std::size_t axis) noexcept {
    const float c = block.corner[2][axis][lane];
    return to_doubles(make_quad(block.corner[0][axis][lane], block.corner[1][axis][lane], c, c));
}

// The component of the cross product of b - a and c - a that follows from two of the corners'
// coordinates.
inline double cross_component(ByCorner y, ByCorner z) noexcept {
    const auto from_a = [](ByCorner v) { return v - permute<0, 0, 0, 0>(v); };
    const ByCorner products = from_a(y) * permute<0, 2, 1, 3>(from_a(z));
    return get<1>(products) - get<2>(products);
}

inline Vec3f normal_of(ByCorner x, ByCorner y, ByCorner z, const RayAxes& axes) noexcept {
    std::array<float, 3> n;
    n[axes.x] = static_cast<float>(cross_component(y, z));
    n[axes.y] = static_cast<float>(cross_component(z, x));
    n[axes.z] = static_cast<float>(cross_component(x, y));
    return {n[0], n[1], n[2]};
}

// True if the ray hits the triangle at a t of at most t_max; then sets the hit.
inline bool decide(const TriangleBlock& block, std::size_t lane, const Ray& ray,
                   const RayAxes& axes, float t_max, Hit& hit) noexcept {
    const auto of = [](Vec3f v, std::size_t axis) {
        return double{std::array<float, 3>{v.x, v.y, v.z}[axis]};
    };
    const double scale_z = 1.0 / of(ray.direction, axes.z);
    const ByCorner raw_x = coordinate(block, lane, axes.x);
    const ByCorner raw_y = coordinate(block, lane, axes.y);
    const ByCorner raw_z = coordinate(block, lane, axes.z);
    const ByCorner z = raw_z - broadcast_double(of(ray.origin, axes.z));
    const ByCorner x = (raw_x - broadcast_double(of(ray.origin, axes.x))) -
                       broadcast_double(of(ray.direction, axes.x) * scale_z) * z;
    const ByCorner y = (raw_y - broadcast_double(of(ray.origin, axes.y))) -
                       broadcast_double(of(ray.direction, axes.y) * scale_z) * z;

    const ByCorner weight = of_previous(x) * of_next(y) - of_previous(y) * of_next(x);
    const FrameExtent extent{greatest(max(abs(x), abs(y))), greatest(abs(z))};
    const double error = weight_error(extent);
    const auto w = to_array(weight);
    const double least = std::min(w[0], std::min(w[1], w[2]));
    const double most = std::max(w[0], std::max(w[1], w[2]));
    if (least < -error && most > error) return false;
    const auto part = to_array(weight * z);
    const double sum = w[0] + w[1] + w[2];
    const double mean = (part[0] + part[1] + part[2]) / sum;
    const bool is_certain = (least > error || most < -error) &&
                            is_precise(mean, sum, greatest(z) + greatest(-z), extent);
    if (!is_certain) return decide_alone(block, lane, ray, t_max, hit);

    const auto t = static_cast<float>(mean * scale_z);
    if (!(t >= ray.t_min && t <= t_max && t <= std::numeric_limits<float>::max())) return false;
    const double per_weight = 1.0 / sum;
    // Members are set one by one: a temporary Hit would be loaded in pieces other than it was
    // stored in, which stalls.
    hit.t = t;
    hit.u = static_cast<float>(w[1] * per_weight);
    hit.v = static_cast<float>(w[2] * per_weight);
    hit.prim = block.id[lane];
    hit.normal = normal_of(raw_x, raw_y, raw_z, axes);
    return true;
}

#else

// The same without registers of four doubles.
inline bool decide(const TriangleBlock& block, std::size_t lane, const Ray& ray,
                   const RayAxes& /*axes*/, float t_max, Hit& hit) noexcept {
    return decide_alone(block, lane, ray, t_max, hit);
}

#endif

}  // namespace COPPICE_SIMD_SET
}  // namespace
}  // namespace coppice::inline v0

COPPICE_SIMD_END

#endif
