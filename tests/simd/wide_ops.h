// The operations of lanes that only the scalar set and those with 256-bit registers have.

#include "simd/set.h"

#if defined(COPPICE_TEST_WIDE_OPS_H) == defined(COPPICE_SIMD_TOGGLE)
#ifdef COPPICE_SIMD_TOGGLE
#undef COPPICE_TEST_WIDE_OPS_H
#else
#define COPPICE_TEST_WIDE_OPS_H
#endif

#include "simd/lane_ops.h"
#include "simd/vectors.h"

#include <array>
#include <cstddef>
#include <cstdint>

#include COPPICE_SIMD_LANES

COPPICE_SIMD_BEGIN

namespace coppice::test {
namespace {
namespace COPPICE_SIMD_SET {

using namespace simd::COPPICE_SIMD_SET;

void put_lanes(Lanes lanes, LaneOutput& out) noexcept {
    std::array<float, 8> values;
    store_unaligned(lanes, values.data());
    out.put(values);
}

void put_quad(Quad quad, LaneOutput& out) noexcept {
    put_lanes(join(quad, quad), out);
}

void put_doubles(Doubles doubles, LaneOutput& out) noexcept {
    alignas(32) std::array<double, 4> values;
    store(doubles, values.data());
    out.put(values);
}

void put_mask(Mask mask, LaneOutput& out) noexcept {
    put_lanes(select(mask, broadcast(1.0F), broadcast(2.0F)), out);
}

void put_mask(DoubleMask mask, LaneOutput& out) noexcept {
    put_doubles(select(mask, broadcast_double(1.0), broadcast_double(2.0)), out);
}

Lanes lanes_at(const std::array<float, 8>& values) noexcept {
    return load_unaligned(values.data());
}

Doubles doubles_at(const std::array<float, 8>& values) noexcept {
    return to_doubles(lower_half(lanes_at(values)));
}

constexpr LaneOp wide_ops[] = {
    {"truncate", Domain::integers,
     [](const LaneInput& in, LaneOutput& out) noexcept {
         put_lanes(truncate(lanes_at(in.a) * broadcast(0.37F)), out);
     }},
    {"store_integers", Domain::integers,
     [](const LaneInput& in, LaneOutput& out) noexcept {
         alignas(32) std::array<std::int32_t, 8> integers;
         store_integers(lanes_at(in.a) * broadcast(0.37F), integers);
         out.put(integers);
     }},
    {"swap_halves", Domain::any,
     [](const LaneInput& in, LaneOutput& out) noexcept {
         put_lanes(swap_halves(lanes_at(in.a)), out);
     }},
    {"with_lane", Domain::any,
     [](const LaneInput& in, LaneOutput& out) noexcept {
         put_lanes(with_lane(lanes_at(in.a), 0, in.b[0]), out);
         put_lanes(with_lane(lanes_at(in.a), 5, in.b[0]), out);
     }},
    {"choose", Domain::any,
     [](const LaneInput& in, LaneOutput& out) noexcept {
         put_lanes(choose(true, lanes_at(in.a), lanes_at(in.b)), out);
         put_lanes(choose(false, lanes_at(in.a), lanes_at(in.b)), out);
     }},
    {"load_points", Domain::any,
     [](const LaneInput& in, LaneOutput& out) noexcept {
         std::array<const float*, 8> points;
         for (std::size_t i = 0; i < 8; ++i) {
             points[i] = (i % 2 == 0 ? in.a.data() : in.b.data()) + i % 6;
         }
         for (const Lanes& axis : load_points(points)) {
             put_lanes(axis, out);
         }
     }},
    {"halves", Domain::any,
     [](const LaneInput& in, LaneOutput& out) noexcept {
         const Lanes a = lanes_at(in.a);
         put_lanes(join(upper_half(a), lower_half(a)), out);
         put_quad(make_quad(in.a[0], in.b[1], in.a[2], in.b[3]), out);
         put_quad(load_point(&in.a[5]), out);
     }},
    {"arithmetic of quads", Domain::finite,
     [](const LaneInput& in, LaneOutput& out) noexcept {
         const Quad a = lower_half(lanes_at(in.a));
         const Quad b = upper_half(lanes_at(in.b));
         put_lanes(join(a + b, a - b), out);
         put_lanes(join(a * b, -a), out);
     }},
    {"comparisons of quads", Domain::any,
     [](const LaneInput& in, LaneOutput& out) noexcept {
         const Quad a = lower_half(lanes_at(in.a));
         const Quad b = upper_half(lanes_at(in.b));
         put_quad(min(a, b), out);
         out.put(greater_equal(a, b));
     }},
    {"axes of quads", Domain::integers,
     [](const LaneInput& in, LaneOutput& out) noexcept {
         const Quad a = lower_half(lanes_at(in.a));
         put_quad(of_next_axis(a), out);
         out.put(sum_of_axes(a));
         out.put(to_integers(a));
     }},
    {"masks", Domain::any,
     [](const LaneInput& in, LaneOutput& out) noexcept {
         const Lanes a = lanes_at(in.a);
         const Lanes b = lanes_at(in.b);
         put_mask(is_less(a, b), out);
         put_mask(is_equal(a, b), out);
         put_mask(is_less(a, b) & is_less(b, lanes_at(in.c)), out);
         put_lanes(keep(is_less(a, b), a), out);
     }},
    {"counters", Domain::any,
     [](const LaneInput& in, LaneOutput& out) noexcept {
         Counters counters = make_counters();
         count(counters, is_less(lanes_at(in.a), lanes_at(in.b)));
         count(counters, is_less(lanes_at(in.b), lanes_at(in.c)));
         put_lanes(to_lanes(counters), out);
     }},
    {"arithmetic of doubles", Domain::finite,
     [](const LaneInput& in, LaneOutput& out) noexcept {
         const Doubles a = doubles_at(in.a);
         const Doubles b = doubles_at(in.b);
         put_doubles(a + b, out);
         put_doubles(a - b, out);
         put_doubles(a * b, out);
         put_doubles(-a, out);
     }},
    {"sizes of doubles", Domain::any,
     [](const LaneInput& in, LaneOutput& out) noexcept {
         const Doubles a = doubles_at(in.a);
         put_doubles(max(a, doubles_at(in.b)), out);
         put_doubles(abs(a), out);
         out.put(less_equal(a, doubles_at(in.b)));
     }},
    {"lanes of doubles", Domain::positive,
     [](const LaneInput& in, LaneOutput& out) noexcept {
         const Doubles a = doubles_at(in.a);
         put_doubles(permute<2, 0, 1, 1>(a), out);
         put_doubles(permute<3, 3, 0, 2>(a), out);
         out.put(std::array{get<0>(a), get<1>(a), get<2>(a), get<3>(a)});
         out.put(greatest(a));
     }},
    {"masks of doubles", Domain::any,
     [](const LaneInput& in, LaneOutput& out) noexcept {
         const Doubles a = doubles_at(in.a);
         const Doubles b = doubles_at(in.b);
         const Doubles c = doubles_at(in.c);
         put_mask(is_less(a, b), out);
         put_mask(is_equal(a, b), out);
         put_mask(is_less(a, b) & is_less(b, c), out);
         put_mask(is_less(a, b) | is_equal(b, c), out);
     }},
    {"vectors", Domain::integers,
     [](const LaneInput& in, LaneOutput& out) noexcept {
         const Lanes3 u{lanes_at(in.a), lanes_at(in.b), lanes_at(in.c)};
         const Lanes3 v{lanes_at(in.b), lanes_at(in.c), lanes_at(in.a)};
         put_lanes(dot(u, v), out);
         put_lanes(length_squared(cross(u, v) + (u - broadcast(2.0F) * v)), out);
     }},
};

constexpr LaneOps kernels{wide_ops};

}  // namespace COPPICE_SIMD_SET
}  // namespace
}  // namespace coppice::test

COPPICE_SIMD_END

#endif
