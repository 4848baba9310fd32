// Lower bounds of squared distances, eight at a time: from a point to the boxes of a node's
// children and to the triangles of a block.
//
// All coordinates are scaled by a power of two to a magnitude of about 1, so that squares neither
// overflow nor underflow. A bound never exceeds the distance that closest_point() finds in double.
// To ensure that, the rounding errors of both computations are subtracted from the bound; relative
// errors are added to the limit that bounds are compared with.

#include "simd/set.h"

#if defined(COPPICE_QUERY_KERNELS_MESH_BOUNDS_H) == defined(COPPICE_SIMD_TOGGLE)
#ifdef COPPICE_SIMD_TOGGLE
#undef COPPICE_QUERY_KERNELS_MESH_BOUNDS_H
#else
#define COPPICE_QUERY_KERNELS_MESH_BOUNDS_H
#endif

#include "coppice/geom/aabb.h"
#include "coppice/tree/bvh8.h"

#include "simd/vectors.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include COPPICE_SIMD_LANES

COPPICE_SIMD_BEGIN

namespace coppice::inline v0 {
namespace {
namespace COPPICE_SIMD_SET {

using namespace simd::COPPICE_SIMD_SET;

// The query point, scaled with the scene to coordinates of about 1.
class ScaledPoint {
public:
    ScaledPoint(Vec3f point, const Aabb& bounds) noexcept
        : scale_(scale_for(point, bounds)), at_(scale_ * point) {}

    [[nodiscard]] float scale() const noexcept { return scale_; }

    [[nodiscard]] Vec3f at() const noexcept { return at_; }

    // A squared distance in scaled units, rounded up by more than the errors of all bounds.
    [[nodiscard]] float scaled_up(double distance_squared) const noexcept {
        constexpr double utmost = 0x1.0p30;  // above any distance; empty slots are at infinity
        const double scaled = distance_squared * scale_ * scale_;
        return static_cast<float>(std::min(scaled, utmost)) * (1.0F + 0x1.0p-18F) + 0x1.0p-110F;
    }

private:
    static float scale_for(Vec3f point, const Aabb& bounds) noexcept {
        float largest = 0.0F;
        for (const Axis axis : all_axes) {
            largest = std::max(largest, std::abs(point[axis]));
            largest = std::max(largest, std::abs(bounds.lower[axis]));
            largest = std::max(largest, std::abs(bounds.upper[axis]));
        }
        return std::ldexp(1.0F, -std::clamp(std::ilogb(largest), -126, 126));
    }

    float scale_;
    Vec3f at_;
};

// Lower bounds of the squared distances to the boxes of all children. The subtrahend covers the
// float rounding of these operations and the double rounding of closest_point(). Empty slots are at
// infinity.
inline Lanes bound_boxes(const Bvh8Node& node, const ScaledPoint& point) noexcept {
    constexpr float rounding = 0x1.0p-44F;
    const Lanes scale = broadcast(point.scale());
    const auto outside = [&](std::size_t axis, float coordinate) {
        const Lanes at = broadcast(coordinate);
        const Lanes below = load(node.bound[axis]) * scale - at;
        const Lanes above = at - load(node.bound[3 + axis]) * scale;
        return max(max(below, above) - broadcast(rounding), broadcast(0.0F));
    };
    const Lanes x = outside(0, point.at().x);
    const Lanes y = outside(1, point.at().y);
    const Lanes z = outside(2, point.at().z);
    return x * x + (y * y + z * z);
}

// The points of eight edges that are closest to the origin.
inline Lanes3 closest_on_edge(const Lanes3& from, const Lanes3& to) noexcept {
    const Lanes nothing = broadcast(0.0F);
    const Lanes one = broadcast(1.0F);
    const Lanes3 along = to - from;
    const Lanes size = length_squared(along);
    const Lanes share = (nothing - dot(from, along)) / select(is_less(nothing, size), size, one);
    return from + min(max(share, nothing), one) * along;
}

inline Lanes sum_of_abs(const Lanes3& v) noexcept {
    return abs(v.x) + (abs(v.y) + abs(v.z));
}

// The corners of eight triangles relative to the query point, and an upper bound of the rounding
// error of a distance along a unit direction.
struct Corners {
    Lanes3 a;
    Lanes3 b;
    Lanes3 c;
    Lanes rounding;
};

// Lower bounds of the squared distances of eight triangles from the origin: their distances along a
// direction. Any direction gives a valid bound; that of the closest point gives the best.
inline Lanes bound_along(const Lanes3& direction, const Corners& corners) noexcept {
    const Lanes nothing = broadcast(0.0F);
    const Lanes size = sum_of_abs(direction);
    const Mask has_size = is_less(broadcast(0x1.0p-100F), size);
    const Lanes3 unit = select(has_size, broadcast(1.0F) / size, nothing) * direction;
    const Lanes to_a = dot(unit, corners.a);
    const Lanes to_b = dot(unit, corners.b);
    const Lanes to_c = dot(unit, corners.c);
    const Lanes least = min(to_a, min(to_b, to_c));
    const Lanes most = max(to_a, max(to_b, to_c));
    const Lanes gap = max(least, nothing - most) - corners.rounding;
    return select(is_less(nothing, gap), gap * gap / length_squared(unit), nothing);
}

inline Lanes3 shorter(const Lanes3& a, const Lanes3& b) noexcept {
    const Mask is_first = is_less(length_squared(a), length_squared(b));
    return {select(is_first, a.x, b.x), select(is_first, a.y, b.y), select(is_first, a.z, b.z)};
}

// Lower bounds of the squared distances to the triangles of a block: the greater of the bounds
// along the direction of their edges' closest point and along their normal. Lanes without a
// triangle have arbitrary values.
inline Lanes bound_triangles(const TriangleBlock& block, const ScaledPoint& point) noexcept {
    const Lanes scale = broadcast(point.scale());
    const Lanes3 origin = broadcast3(point.at());
    const auto corner = [&](std::size_t at) {
        const auto& axes = block.corner[at];
        return scale * Lanes3{load(axes[0]), load(axes[1]), load(axes[2])} - origin;
    };
    const Lanes3 a = corner(0);
    const Lanes3 b = corner(1);
    const Lanes3 c = corner(2);
    const Lanes size = sum_of_abs(a) + sum_of_abs(b) + sum_of_abs(c);
    const Corners corners{a, b, c, broadcast(0x1.0p-20F) * size + broadcast(0x1.0p-44F)};
    const Lanes3 closest =
        shorter(closest_on_edge(a, b), shorter(closest_on_edge(b, c), closest_on_edge(c, a)));
    return max(bound_along(closest, corners), bound_along(cross(b - a, c - a), corners));
}

}  // namespace COPPICE_SIMD_SET
}  // namespace
}  // namespace coppice::inline v0

COPPICE_SIMD_END

#endif
