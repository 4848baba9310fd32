// Intersection of a ray with the eight triangles of a block, as far as single precision can decide
// it.
//
// The test is that of TriangleTest [Woop2013], with a bound on its rounding error. Let u = 2^-24, m
// the largest sheared x or y of a triangle, and Z its largest z relative to the origin (all in the
// ray's axes, where shears are at most 1):
// - A sheared coordinate has an error of at most 5 u (m + Z): one rounding of each difference,
//   three of the shear, one of the product, one of the sum, and |x| <= m + Z before the shear.
// - Hence a weight (edge function) has an error of at most 20 u m (m + Z) + 50 u^2 (m + Z)^2 + 4 u
//   m^2, which is less than `error` = (m + Z) (32 u m + 64 u^2 (m + Z)), plus what underflows.
// - t is an average of the corners' z, with weights of one sign. Errors of the weights move it by
//   less than 8 error / |sum of weights| of the corners' range of z, if that ratio is less than 1.
//   Roundings move it by 10 u Z, for which 32 u Z is used.
//
// A triangle whose weights have both signs beyond the error is certainly missed. One whose weights
// have one sign beyond the error is certainly hit, at a t in a known interval. All others, and NaN
// from overflow, are left to TriangleTest: where a sheared x or y is NaN, its z is infinite, and so
// is Z.

#include "simd/set.h"

#if defined(COPPICE_TRACE_KERNELS_BVH8_TRIANGLES_H) == defined(COPPICE_SIMD_TOGGLE)
#ifdef COPPICE_SIMD_TOGGLE
#undef COPPICE_TRACE_KERNELS_BVH8_TRIANGLES_H
#else
#define COPPICE_TRACE_KERNELS_BVH8_TRIANGLES_H
#endif

#include "coppice/geom/ray.h"
#include "coppice/tree/bvh8.h"

#include "simd/vectors.h"

#include <array>
#include <cmath>
#include <cstddef>

#include COPPICE_SIMD_LANES

COPPICE_SIMD_BEGIN

namespace coppice::inline v0 {
namespace {
namespace COPPICE_SIMD_SET {

using namespace simd::COPPICE_SIMD_SET;

/// A ray in the axes of the triangle test, where z is the axis of its direction's longest
/// component.
struct ShearedRay {
    explicit ShearedRay(const Ray& ray) noexcept : axes(ray.direction) {
        const std::array<float, 3> d{ray.direction.x, ray.direction.y, ray.direction.z};
        const std::array<float, 3> o{ray.origin.x, ray.origin.y, ray.origin.z};
        scale_z = 1.0F / d[axes.z];
        origin = {broadcast(o[axes.x]), broadcast(o[axes.y]), broadcast(o[axes.z])};
        shear_x = broadcast(d[axes.x] * scale_z);
        shear_y = broadcast(d[axes.y] * scale_z);
    }

    RayAxes axes;
    float scale_z;
    Lanes3 origin;
    Lanes shear_x;
    Lanes shear_y;
};

// The result of the single-precision test of a block's triangles.
struct Sifted {
    unsigned possible;  // mask of the triangles that may be hit
    unsigned certain;   // mask of those that are hit, at a t in [first, last]
    alignas(32) std::array<float, bvh8_width> first;
    alignas(32) std::array<float, bvh8_width> last;
};

// Computes the intervals of t in which the triangles of `sifted.possible` are certainly hit.
inline void bound_hits(const Lanes3& weight, const Lanes3& z, Lanes z_size, Lanes error,
                       float scale_z, Sifted& sifted) noexcept {
    const Lanes sum = weight.x + (weight.y + weight.z);
    const Lanes per_sum = broadcast(1.0F) / sum;
    const Lanes mean = (weight.x * z.x + (weight.y * z.y + weight.z * z.z)) * per_sum;
    const Lanes range = max(z.x, max(z.y, z.z)) - min(z.x, min(z.y, z.z));
    const Lanes share = broadcast(8.0F) * error * abs(per_sum);
    const Lanes slack = share * range + broadcast(0x1.0p-19F) * z_size;
    const Lanes at = mean * broadcast(scale_z);
    const Lanes wide = slack * broadcast(std::abs(scale_z)) + broadcast(0x1.0p-126F);
    store(at - wide, sifted.first);
    store(at + wide, sifted.last);
    const Lanes none = at - at;  // NaN if `at` has overflowed
    sifted.certain &= less(share + none, broadcast(1.0F));
}

// Sets `possible`, and the other members if any triangle is possible.
inline void sift_triangles(const TriangleBlock& block, const ShearedRay& ray,
                           Sifted& sifted) noexcept {
    const auto corner = [&](std::size_t at) {
        const auto& axes = block.corner[at];
        const Lanes z = load(axes[ray.axes.z]) - ray.origin.z;
        const Lanes x = load(axes[ray.axes.x]) - ray.origin.x;
        const Lanes y = load(axes[ray.axes.y]) - ray.origin.y;
        return Lanes3{subtract_product(x, ray.shear_x, z), subtract_product(y, ray.shear_y, z), z};
    };
    const Lanes3 a = corner(0);
    const Lanes3 b = corner(1);
    const Lanes3 c = corner(2);
    const Lanes3 weight{multiply_subtract(c.x, b.y, c.y * b.x),
                        multiply_subtract(a.x, c.y, a.y * c.x),
                        multiply_subtract(b.x, a.y, b.y * a.x)};
    const Lanes m = larger_size(larger_size(larger_size(a.x, a.y), larger_size(b.x, b.y)),
                                larger_size(c.x, c.y));
    const Lanes z_size = larger_size(a.z, larger_size(b.z, c.z));
    const Lanes reach = m + z_size;
    // The products come first: they overflow wherever those of the weights do.
    const Lanes error = broadcast(0x1.0p-19F) * (reach * m) +
                        (broadcast(0x1.0p-42F) * (reach * reach) + broadcast(0x1.0p-126F));
    const Lanes least = min(weight.x, min(weight.y, weight.z));
    const Lanes most = max(weight.x, max(weight.y, weight.z));
    const Lanes minus_error = broadcast(0.0F) - error;
    const Lanes id_corner = load(block.corner[0][0]);  // NaN in lanes without a triangle
    const unsigned is_missed = less(least, minus_error) & less(error, most);
    sifted.possible = less_equal(id_corner, id_corner) & ~is_missed;
    if (sifted.possible == 0) return;
    sifted.certain = sifted.possible & (less(error, least) | less(most, minus_error));
    bound_hits(weight, {a.z, b.z, c.z}, z_size, error, ray.scale_z, sifted);
}

}  // namespace COPPICE_SIMD_SET
}  // namespace
}  // namespace coppice::inline v0

COPPICE_SIMD_END

#endif
