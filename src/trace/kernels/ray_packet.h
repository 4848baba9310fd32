// Ray packets: eight rays that are nearly parallel, and their frustum.

#include "simd/set.h"

#if defined(COPPICE_TRACE_KERNELS_RAY_PACKET_H) == defined(COPPICE_SIMD_TOGGLE)
#ifdef COPPICE_SIMD_TOGGLE
#undef COPPICE_TRACE_KERNELS_RAY_PACKET_H
#else
#define COPPICE_TRACE_KERNELS_RAY_PACKET_H
#endif

#include "coppice/geom/aabb.h"
#include "coppice/geom/ray.h"

#include "trace/kernels/bvh8_boxes.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <span>

#include COPPICE_SIMD_LANES

COPPICE_SIMD_BEGIN

namespace coppice::inline v0 {
namespace {
namespace COPPICE_SIMD_SET {

using namespace simd::COPPICE_SIMD_SET;

constexpr std::size_t packet_size = 8;

using OfRays = std::array<float, packet_size>;  // one number per ray

// Eight rays and their frustum. All pass is_fast(), and their directions have the same signs.
struct RayPacket {
    // Refers to eight rays; call gather() before use.
    explicit RayPacket(std::span<const Ray, packet_size> eight) noexcept
        : rays(eight), each(eight.front().direction), frustum(eight.front().direction) {}

    // Loads the rays. Returns false if they cannot form a packet.
    bool gather(const Aabb& bounds) noexcept {
        if (!have_same_signs()) return false;
        alignas(32) std::array<OfRays, 8> rows;  // origin, direction, t_min, t_max
        for (std::size_t i = 0; i < packet_size; ++i) {
            const auto numbers = std::bit_cast<std::array<float, 8>>(rays[i]);
            for (std::size_t k = 0; k < numbers.size(); ++k) {
                rows[k][i] = numbers[k];
            }
        }
        if (reach_of(bounds) > fast_reach || !are_fast(rows) || !are_close(rows)) return false;
        set_axis(&Lanes3::x, rows[0], rows[3]);
        set_axis(&Lanes3::y, rows[1], rows[4]);
        set_axis(&Lanes3::z, rows[2], rows[5]);
        return true;
    }

    // Ray i in all lanes.
    [[nodiscard]] FastRay ray(std::size_t i) const noexcept {
        FastRay one(rays[i].direction);
        const auto spread = [&](const Lanes3& v) {
            return Lanes3{broadcast_lane(v.x, i), broadcast_lane(v.y, i), broadcast_lane(v.z, i)};
        };
        one.to_near = spread(each.to_near);
        one.to_far = spread(each.to_far);
        one.near_at_0 = spread(each.near_at_0);
        one.far_at_0 = spread(each.far_at_0);
        return one;
    }

    std::span<const Ray, packet_size> rays;
    FastRay each;  // one ray per lane
    FastRay frustum;

private:
    [[nodiscard]] bool have_same_signs() const noexcept {
        const auto signs = [](Vec3f d) {
            return unsigned{std::signbit(d.x)} | unsigned{std::signbit(d.y)} << 1U |
                   unsigned{std::signbit(d.z)} << 2U;
        };
        const unsigned first = signs(rays.front().direction);
        for (const Ray& ray : rays.subspan<1>()) {
            if (signs(ray.direction) != first) return false;
        }
        return true;
    }

    // is_fast() for all rays at once.
    static bool are_fast(const std::array<OfRays, 8>& rows) noexcept {
        unsigned fast =
            less_equal(broadcast(0.0F), load(rows[6])) & less_equal(load(rows[6]), load(rows[7]));
        for (std::size_t k = 0; k < 6; ++k) {
            fast &= less_equal(abs(load(rows[k])), broadcast(fast_reach));
        }
        for (std::size_t k = 3; k < 6; ++k) {
            fast &= less_equal(broadcast(1.0F / fast_reach), abs(load(rows[k])));
        }
        return fast == 0xffU;
    }

    // True if no direction deviates by more than 14 degrees from the first. Other packets diverge
    // soon.
    static bool are_close(const std::array<OfRays, 8>& rows) noexcept {
        const auto dot = [&](Lanes x, Lanes y, Lanes z) {
            return x * load(rows[3]) + (y * load(rows[4]) + z * load(rows[5]));
        };
        const Lanes with_first =
            dot(broadcast(rows[3][0]), broadcast(rows[4][0]), broadcast(rows[5][0]));
        const Lanes squares = dot(load(rows[3]), load(rows[4]), load(rows[5]));
        const Lanes first = broadcast_lane(squares, 0);
        return less_equal(broadcast(0.94F) * (squares * first), with_first * with_first) == 0xffU;
    }

    // Sets an axis of the rays and of the frustum. The frustum's lower bound of non-negative
    // distances to near faces is that of the most advanced origin and the longest direction
    // component. Its upper bound of distances to far faces uses the opposite extremes.
    void set_axis(Lanes Lanes3::*axis, const OfRays& origin, const OfRays& direction) noexcept {
        using Line = FastRay::Line;
        const Line own{load(origin), broadcast(1.0F) / load(direction)};
        each.set_axis(axis, own, own);
        const auto [low, high] = std::minmax_element(origin.begin(), origin.end());
        const auto [least, most] = std::minmax_element(direction.begin(), direction.end());
        const Line upper{broadcast(*high), broadcast(1.0F / *most)};
        const Line lower{broadcast(*low), broadcast(1.0F / *least)};
        *least < 0.0F ? frustum.set_axis(axis, lower, upper) : frustum.set_axis(axis, upper, lower);
    }
};

}  // namespace COPPICE_SIMD_SET
}  // namespace
}  // namespace coppice::inline v0

COPPICE_SIMD_END

#endif
