// How a ray meets the eight children of an 8-wide node.
//
// All eight boxes are cut with the ray at once, and intervals are widened by more than rounding can
// do to them [Ize2013], so that no box which the ray touches is passed over. Two ways:
// - FastRay, for nearly all rays: t = bound * inverse - origin * inverse, one operation a plane.
//   The difference may cancel: its error is relative to origin * inverse, so that boxes are in
//   effect widened by 8 units of rounding of the origin's coordinates, besides those of t.
// - RobustRay, for the others: t = (bound - origin) * inverse, which is exact to 3 units of
//   rounding for any origin. A direction component of zero (or -0) gives infinite distances, or NaN
//   where the origin lies in the plane of a face; minimum and maximum then take their second
//   argument, so such a face does not cut. Of distances of either sign, as a t_min below 0 allows,
//   both ends are widened.

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

// More than all that rounding does to a distance.
constexpr float shrink = 1.0F - 0x1.0p-21F;
constexpr float grow = 1.0F + 0x1.0p-21F;

// The reciprocal of a direction's component, or NaN where it or a distance to a box could overflow:
// then nothing is cut on that axis.
inline float inverse_of(Axis axis, const Ray& ray, const Aabb& bounds) noexcept {
    constexpr float far = 0x1.0p126F;
    const float direction = ray.direction[axis];
    const bool is_tiny = direction != 0.0F && std::abs(direction) < 0x1.0p-100F;
    const bool is_near =
        std::abs(ray.origin[axis]) < far && bounds.lower[axis] > -far && bounds.upper[axis] < far;
    return is_near && !is_tiny ? 1.0F / direction : std::numeric_limits<float>::quiet_NaN();
}

// Byte offsets in a Bvh8Node of the rows of bounds that a ray comes to first and last on each axis.
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

// The largest coordinate of a box, without its sign.
inline float reach_of(const Aabb& box) noexcept {
    const auto larger = [](float a, float b) { return std::max(std::abs(a), std::abs(b)); };
    return std::max({larger(box.lower.x, box.upper.x), larger(box.lower.y, box.upper.y),
                     larger(box.lower.z, box.upper.z)});
}

constexpr float fast_reach = 0x1.0p60F;

// Whether products with the ray's origin and inverse direction, and with the bounds of all boxes,
// neither overflow nor are NaN, and nothing behind the origin matters. Such a ray is_traceable().
// All numbers of the ray at once: a branch for each would cost 7 ns a ray.
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

// Of rays that pass is_fast() in a tree's bounds, all lanes the same or each a ray of its own.
// Never meets an empty child: its bounds are infinite the wrong way round.
struct FastRay {
    static constexpr bool never_meets_empty = true;

    // To be set on each axis.
    explicit FastRay(Vec3f direction) noexcept : near_row(direction) {}

    explicit FastRay(const Ray& ray) noexcept : FastRay(ray.direction) {
        const Lanes3 origin = broadcast3(ray.origin);
        const Lanes3 direction = broadcast3(ray.direction);
        for (const auto axis : {&Lanes3::x, &Lanes3::y, &Lanes3::z}) {
            const Lanes inverse = broadcast(1.0F) / direction.*axis;
            set_axis(axis, {origin.*axis, inverse}, {origin.*axis, inverse});
        }
    }

    // An origin's coordinate and the inverse of a direction's.
    struct Line {
        Lanes origin;
        Lanes inverse;
    };

    // Distances to near faces are those on one line, to far faces those on another.
    void set_axis(Lanes Lanes3::*axis, Line near, Line far) noexcept {
        // Never 0, so that a face which the ray starts on is not at -0.
        const auto slack = [](Line line) {
            return broadcast(0x1.0p-21F) * abs(line.origin * line.inverse) + broadcast(0x1.0p-100F);
        };
        to_near.*axis = broadcast(shrink) * near.inverse;
        to_far.*axis = broadcast(grow) * far.inverse;
        near_at_0.*axis = near.origin * to_near.*axis + slack(near);
        far_at_0.*axis = far.origin * to_far.*axis - slack(far);
    }

    // The children whose boxes the ray meets between enter and exit, which are not negative: a
    // negative distance to a near face does not raise enter, one to a far face is a miss.
    [[nodiscard]] BoxHits meet(const Bvh8Node& node, Lanes enter, Lanes exit) const noexcept {
        return cut([&](std::size_t row) { return load_row(node, row); }, enter, exit);
    }

    // The rays, if each lane has its own, that meet one child.
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

// Of any traceable ray.
struct RobustRay {
    static constexpr bool never_meets_empty = false;

    RobustRay(const Ray& ray, const Aabb& bounds) noexcept
        : near_row(ray.direction),
          origin(broadcast3(ray.origin)),
          inverse(
              broadcast3(Vec3f{inverse_of(Axis::x, ray, bounds), inverse_of(Axis::y, ray, bounds),
                               inverse_of(Axis::z, ray, bounds)})) {}

    // The children whose boxes the ray may meet between enter and exit, at distances of either
    // sign. Empty ones only if no axis cuts.
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
        // Two by two: of a NaN the second argument is left, at worst less is cut.
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
