// Intersection of a ray with the boxes of an 8-wide node's children.
//
// All eight boxes are tested at once. Intervals are widened by more than the rounding error
// [Ize2013], so that no box which the ray touches is skipped. There are two traversals:
// - FastRay, for nearly all rays: t = bound * inverse - origin * inverse, one fused operation a
//   plane. The difference may cancel, so its error is relative to origin * inverse. In effect,
//   boxes are widened by 8 rounding units of the origin's coordinates, besides those of t.
// - RobustRay, for all other rays: t = (bound - origin) * inverse, with an error of 3 rounding
//   units for any origin. A direction component of zero (or -0) gives infinite distances, or NaN
//   where the origin lies in the plane of a face. Minimum and maximum then return their second
//   argument, so that such a face does not cut. Both ends are widened for distances of either sign,
//   which a t_min below 0 allows.

#include "simd/set.h"

#if defined(COPPICE_TRACE_KERNELS_BVH8_BOXES_H) == defined(COPPICE_SIMD_TOGGLE)
#ifdef COPPICE_SIMD_TOGGLE
#undef COPPICE_TRACE_KERNELS_BVH8_BOXES_H
#else
#define COPPICE_TRACE_KERNELS_BVH8_BOXES_H
#endif

#include "coppice/geom/aabb.h"
#include "coppice/geom/ray.h"
#include "coppice/tree/bvh8.h"

#include "simd/vectors.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <limits>

#include COPPICE_SIMD_LANES

COPPICE_SIMD_BEGIN

namespace coppice::inline v0 {
namespace {
namespace COPPICE_SIMD_SET {

using namespace simd::COPPICE_SIMD_SET;

inline Lanes broadcast_lane(const Lanes& lanes, std::size_t i) noexcept {
    alignas(32) std::array<float, 8> values;
    store(lanes, values);
    return broadcast(values[i]);
}

// Factors that change a distance by more than its rounding error.
constexpr float shrink = 1.0F - 0x1.0p-21F;
constexpr float grow = 1.0F + 0x1.0p-21F;

// The reciprocal of a direction's component, or NaN if it or a distance to a box could overflow.
// With NaN, boxes are not cut on that axis.
inline float inverse_of(Axis axis, const Ray& ray, const Aabb& bounds) noexcept {
    constexpr float far = 0x1.0p126F;
    const float direction = ray.direction[axis];
    const bool is_tiny = direction != 0.0F && std::abs(direction) < 0x1.0p-100F;
    const bool is_near =
        std::abs(ray.origin[axis]) < far && bounds.lower[axis] > -far && bounds.upper[axis] < far;
    return is_near && !is_tiny ? 1.0F / direction : std::numeric_limits<float>::quiet_NaN();
}

// The byte offsets, in a Bvh8Node, of the bounds that a ray reaches first on each axis; far_of()
// gives the opposite bounds.
struct RowOffsets {
    RowOffsets() = default;

    explicit RowOffsets(Vec3f direction) noexcept
        : x(offset_of_near(0, direction.x)),
          y(offset_of_near(1, direction.y)),
          z(offset_of_near(2, direction.z)) {}

    static constexpr std::size_t row_size = sizeof(Bvh8Node::bound[0]);

    static std::size_t offset_of_near(std::size_t axis, float direction) noexcept {
        return row_size * (axis + (std::signbit(direction) ? 3 : 0));
    }

    static constexpr std::size_t far_of(std::size_t axis, std::size_t near) noexcept {
        return row_size * (2 * axis + 3) - near;
    }

    std::size_t x;
    std::size_t y;
    std::size_t z;
};

inline Lanes load_row(const Bvh8Node& node, std::size_t offset) noexcept {
    return load(*reinterpret_cast<const std::array<float, bvh8_width>*>(
        reinterpret_cast<const char*>(node.bound.data()) + offset));
}

struct BoxHits {
    unsigned mask;
    Lanes enter;
};

// The largest absolute value of a box's coordinates.
inline float reach_of(const Aabb& box) noexcept {
    const auto larger = [](float a, float b) { return std::max(std::abs(a), std::abs(b)); };
    return std::max({larger(box.lower.x, box.upper.x), larger(box.lower.y, box.upper.y),
                     larger(box.lower.z, box.upper.z)});
}

constexpr float fast_reach = 0x1.0p60F;

// True if FastRay is valid for a ray: it is traceable with t_min >= 0, and no product of its
// origin, its inverse direction and the bounds of boxes overflows or is NaN. All numbers of the ray
// are tested at once; a branch for each would cost 7 ns a ray.
inline bool is_fast(const Ray& ray, const Aabb& bounds) noexcept {
    constexpr unsigned of_origin = 0b000111;
    constexpr unsigned of_direction = 0b111000;
    alignas(32) const auto numbers = std::bit_cast<std::array<float, 8>>(ray);
    const Lanes sizes = abs(load(numbers));
    const unsigned near = less_equal(sizes, broadcast(fast_reach));
    const unsigned plain = less_equal(broadcast(1.0F / fast_reach), sizes);
    const float reach = reach_of(bounds);
    return (near & (of_origin | of_direction)) == (of_origin | of_direction) &&
           (plain & of_direction) == of_direction && ray.t_min >= 0.0F && ray.t_min <= ray.t_max &&
           reach <= fast_reach;
}

// The fast traversal, for rays that pass is_fast() in a tree's bounds. All lanes hold the same ray,
// or each lane its own. Empty children have inverted bounds (min = +inf, max = -inf), so no ray
// meets them.
struct FastRay {
    static constexpr bool never_meets_empty = true;

    // Initializes the directions only; call set_axis() for each axis.
    explicit FastRay(Vec3f direction) noexcept : near_row(direction) {}

    explicit FastRay(const Ray& ray) noexcept : FastRay(ray.direction) {
        const Lanes3 origin = broadcast3(ray.origin);
        const Lanes3 direction = broadcast3(ray.direction);
        for (const auto axis : {&Lanes3::x, &Lanes3::y, &Lanes3::z}) {
            const Lanes inverse = broadcast(1.0F) / direction.*axis;
            set_axis(axis, {origin.*axis, inverse}, {origin.*axis, inverse});
        }
    }

    // The origin's coordinate and the inverse direction on one axis.
    struct Line {
        Lanes origin;
        Lanes inverse;
    };

    // Uses the line `near` for distances to near faces, and `far` for those to far faces.
    void set_axis(Lanes Lanes3::*axis, Line near, Line far) noexcept {
        // Never 0: otherwise a face that the ray starts on would be at -0.
        const auto slack = [](Line line) {
            return broadcast(0x1.0p-21F) * abs(line.origin * line.inverse) + broadcast(0x1.0p-100F);
        };
        to_near.*axis = broadcast(shrink) * near.inverse;
        to_far.*axis = broadcast(grow) * far.inverse;
        near_at_0.*axis = near.origin * to_near.*axis + slack(near);
        far_at_0.*axis = far.origin * to_far.*axis - slack(far);
    }

    // The children whose boxes the ray meets between `enter` and `exit`, which must not be
    // negative. A negative distance to a near face does not raise `enter`; one to a far face is a
    // miss.
    [[nodiscard]] BoxHits meet(const Bvh8Node& node, Lanes enter, Lanes exit) const noexcept {
        return cut([&](std::size_t row) { return load_row(node, row); }, enter, exit);
    }

    // For lanes with a ray each: a mask of the rays that meet one child.
    [[nodiscard]] unsigned meet_child(const Bvh8Node& node, std::size_t slot, Lanes enter,
                                      Lanes exit) const noexcept {
        const char* const bounds = reinterpret_cast<const char*>(node.bound.data());
        return cut(
                   [&](std::size_t row) {
                       return broadcast(reinterpret_cast<const float*>(bounds + row)[slot]);
                   },
                   enter, exit)
            .mask;
    }

    template <typename Rows>
    [[nodiscard]] BoxHits cut(Rows&& bounds, Lanes enter, Lanes exit) const noexcept {
        const auto near = [&](std::size_t row, Lanes inverse, Lanes at_0) {
            return multiply_subtract(bounds(row), inverse, at_0);
        };
        const auto far = [&](std::size_t axis, std::size_t row, Lanes inverse, Lanes at_0) {
            return multiply_subtract(bounds(RowOffsets::far_of(axis, row)), inverse, at_0);
        };
        enter = bits_max(bits_max(near(near_row.x, to_near.x, near_at_0.x),
                                  near(near_row.y, to_near.y, near_at_0.y)),
                         bits_max(near(near_row.z, to_near.z, near_at_0.z), enter));
        exit = bits_min(bits_min(far(0, near_row.x, to_far.x, far_at_0.x),
                                 far(1, near_row.y, to_far.y, far_at_0.y)),
                        bits_min(far(2, near_row.z, to_far.z, far_at_0.z), exit));
        return {bits_less_equal(enter, exit), enter};
    }

    RowOffsets near_row;
    Lanes3 to_near;
    Lanes3 to_far;
    Lanes3 near_at_0;
    Lanes3 far_at_0;
};

// The robust traversal, for any traceable ray.
struct RobustRay {
    static constexpr bool never_meets_empty = false;

    RobustRay(const Ray& ray, const Aabb& bounds) noexcept
        : near_row(ray.direction),
          origin(broadcast3(ray.origin)),
          inverse(
              broadcast3(Vec3f{inverse_of(Axis::x, ray, bounds), inverse_of(Axis::y, ray, bounds),
                               inverse_of(Axis::z, ray, bounds)})) {}

    // The children whose boxes the ray may meet between `enter` and `exit`, at distances of either
    // sign. Includes empty children only if no axis cuts.
    [[nodiscard]] BoxHits meet(const Bvh8Node& node, Lanes enter, Lanes exit) const noexcept {
        const Lanes low = broadcast(shrink * shrink);
        const Lanes high = broadcast(grow * grow);
        const auto distance = [&](std::size_t row, Lanes from, Lanes per_unit) {
            return (load_row(node, row) - from) * per_unit;
        };
        const auto near = [&](std::size_t row, Lanes from, Lanes per_unit) {
            const Lanes t = distance(row, from, per_unit);
            return min(t * low, t * high);
        };
        const auto far = [&](std::size_t axis, std::size_t row, Lanes from, Lanes per_unit) {
            const Lanes t = distance(RowOffsets::far_of(axis, row), from, per_unit);
            return max(t * low, t * high);
        };
        // The order of arguments matters: a NaN is replaced by the second argument, so that at
        // worst less is cut.
        enter =
            max(max(near(near_row.x, origin.x, inverse.x), near(near_row.y, origin.y, inverse.y)),
                max(near(near_row.z, origin.z, inverse.z), enter));
        exit = min(
            min(far(0, near_row.x, origin.x, inverse.x), far(1, near_row.y, origin.y, inverse.y)),
            min(far(2, near_row.z, origin.z, inverse.z), exit));
        return {less_equal(enter, exit), enter};
    }

    RowOffsets near_row;
    Lanes3 origin;
    Lanes3 inverse;
};

}  // namespace COPPICE_SIMD_SET
}  // namespace
}  // namespace coppice::inline v0

COPPICE_SIMD_END

#endif
