// The operations that every set of lanes has.

#include "simd/set.h"

#if defined(COPPICE_TEST_NARROW_OPS_H) == defined(COPPICE_SIMD_TOGGLE)
#ifdef COPPICE_SIMD_TOGGLE
#undef COPPICE_TEST_NARROW_OPS_H
#else
#define COPPICE_TEST_NARROW_OPS_H
#endif

#include "simd/lane_ops.h"

#include <array>

#include COPPICE_SIMD_LANES

COPPICE_SIMD_BEGIN

namespace coppice::test {
namespace {
namespace COPPICE_SIMD_SET {

using namespace simd::COPPICE_SIMD_SET;

// Nothing here is named like an operation: lookup would end with it.
template <typename Operation>
void run_lanes(const LaneInput& in, LaneOutput& out, const Operation& operation) noexcept {
    alignas(32) std::array<float, 8> result;
    store(operation(load(in.a), load(in.b), load(in.c)), result);
    out.put(result);
}

constexpr LaneOp narrow_ops[] = {
    {"load and store", Domain::any,
     [](const LaneInput& in, LaneOutput& out) noexcept {
         run_lanes(in, out, [](Lanes a, Lanes, Lanes) { return a; });
     }},
    {"broadcast", Domain::any,
     [](const LaneInput& in, LaneOutput& out) noexcept {
         run_lanes(in, out, [&](Lanes, Lanes, Lanes) { return broadcast(in.a[2]); });
     }},
    {"+", Domain::finite,
     [](const LaneInput& in, LaneOutput& out) noexcept {
         run_lanes(in, out, [](Lanes a, Lanes b, Lanes) { return a + b; });
     }},
    {"-", Domain::finite,
     [](const LaneInput& in, LaneOutput& out) noexcept {
         run_lanes(in, out, [](Lanes a, Lanes b, Lanes) { return a - b; });
     }},
    {"*", Domain::finite,
     [](const LaneInput& in, LaneOutput& out) noexcept {
         run_lanes(in, out, [](Lanes a, Lanes b, Lanes) { return a * b; });
     }},
    {"/", Domain::positive,
     [](const LaneInput& in, LaneOutput& out) noexcept {
         run_lanes(in, out, [](Lanes a, Lanes b, Lanes) { return a / (b + broadcast(1.0F)); });
     }},
    {"multiply_subtract", Domain::integers,
     [](const LaneInput& in, LaneOutput& out) noexcept {
         run_lanes(in, out, [](Lanes a, Lanes b, Lanes c) { return multiply_subtract(a, b, c); });
     }},
    {"subtract_product", Domain::integers,
     [](const LaneInput& in, LaneOutput& out) noexcept {
         run_lanes(in, out, [](Lanes a, Lanes b, Lanes c) { return subtract_product(a, b, c); });
     }},
    {"min", Domain::any,
     [](const LaneInput& in, LaneOutput& out) noexcept {
         run_lanes(in, out, [](Lanes a, Lanes b, Lanes) { return min(a, b); });
     }},
    {"max", Domain::any,
     [](const LaneInput& in, LaneOutput& out) noexcept {
         run_lanes(in, out, [](Lanes a, Lanes b, Lanes) { return max(a, b); });
     }},
    {"abs", Domain::any,
     [](const LaneInput& in, LaneOutput& out) noexcept {
         run_lanes(in, out, [](Lanes a, Lanes, Lanes) { return abs(a); });
     }},
    {"larger_size", Domain::finite,
     [](const LaneInput& in, LaneOutput& out) noexcept {
         run_lanes(in, out, [](Lanes a, Lanes b, Lanes) { return larger_size(a, b); });
     }},
    {"bits_max", Domain::positive,
     [](const LaneInput& in, LaneOutput& out) noexcept {
         run_lanes(in, out, [](Lanes a, Lanes b, Lanes) { return bits_max(a, b); });
     }},
    {"bits_min", Domain::positive,
     [](const LaneInput& in, LaneOutput& out) noexcept {
         run_lanes(in, out, [](Lanes a, Lanes b, Lanes) { return bits_min(a, b); });
     }},
    {"less", Domain::any,
     [](const LaneInput& in, LaneOutput& out) noexcept { out.put(less(load(in.a), load(in.b))); }},
    {"less_equal", Domain::any,
     [](const LaneInput& in, LaneOutput& out) noexcept {
         out.put(less_equal(load(in.a), load(in.b)));
     }},
    {"bits_less_equal", Domain::positive,
     [](const LaneInput& in, LaneOutput& out) noexcept {
         out.put(bits_less_equal(load(in.a), load(in.b)));
     }},
};

constexpr LaneOps kernels{narrow_ops};

}  // namespace COPPICE_SIMD_SET
}  // namespace
}  // namespace coppice::test

COPPICE_SIMD_END

#endif
