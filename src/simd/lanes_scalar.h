// Lanes as arrays, for any processor. This file documents the operations of every instruction set.
#pragma once

#include "simd/doubles_scalar.h"
#include "simd/registers_scalar.h"
#include "simd/target.h"

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>

namespace coppice::inline v0::simd::scalar {

/// Loads from and stores to an array aligned to 32 bytes.
COPPICE_LANES Lanes load(const std::array<float, 8>& from) noexcept {
    return {from};
}

COPPICE_LANES void store(const Lanes& lanes, std::array<float, 8>& to) noexcept {
    to = lanes.lane;
}

/// Loads from and stores to eight floats at any address.
COPPICE_LANES Lanes load_unaligned(const float* from) noexcept {
    return {{from[0], from[1], from[2], from[3], from[4], from[5], from[6], from[7]}};
}

COPPICE_LANES void store_unaligned(const Lanes& lanes, float* to) noexcept {
    for (std::size_t i = 0; i < 8; ++i) {
        to[i] = lanes.lane[i];
    }
}

COPPICE_LANES Lanes broadcast(float value) noexcept {
    return {{value, value, value, value, value, value, value, value}};
}

COPPICE_LANES Lanes operator/(const Lanes& a, const Lanes& b) noexcept {
    return each(a, b, [](float x, float y) { return x / y; });
}

/// a * b - c, rounded once or twice.
COPPICE_LANES Lanes multiply_subtract(const Lanes& a, const Lanes& b, const Lanes& c) noexcept {
    return a * b - c;
}

/// a - b * c, rounded once or twice.
COPPICE_LANES Lanes subtract_product(const Lanes& a, const Lanes& b, const Lanes& c) noexcept {
    return a - b * c;
}

/// The larger of two absolute values, lane by lane. If one is NaN, the result is the other or NaN.
COPPICE_LANES Lanes larger_size(const Lanes& a, const Lanes& b) noexcept {
    return max(abs(a), abs(b));
}

/// Rounds towards 0. The values must fit in an int32.
COPPICE_LANES Lanes truncate(const Lanes& a) noexcept {
    return each(a, a, [](float x, float /*same*/) {
        return static_cast<float>(static_cast<std::int32_t>(x));
    });
}

/// A bit for every lane in which a < b.
COPPICE_LANES unsigned less(const Lanes& a, const Lanes& b) noexcept {
    return bits_where(a, b, [](float x, float y) { return x < y; });
}

/// Maximum, minimum and comparison a <= b as integers, in one cycle instead of four. The order is
/// that of floats, except for NaN and for two negative values (or -0).
COPPICE_LANES Lanes bits_max(const Lanes& a, const Lanes& b) noexcept {
    return max(a, b);
}

COPPICE_LANES Lanes bits_min(const Lanes& a, const Lanes& b) noexcept {
    return min(a, b);
}

COPPICE_LANES unsigned bits_less_equal(const Lanes& a, const Lanes& b) noexcept {
    return less_equal(a, b);
}

/// Rounds towards 0 and stores to an array aligned to 32 bytes. The values must fit in an int32.
COPPICE_LANES void store_integers(const Lanes& lanes, std::array<std::int32_t, 8>& to) noexcept {
    for (std::size_t i = 0; i < 8; ++i) {
        to[i] = static_cast<std::int32_t>(lanes.lane[i]);
    }
}

/// Swaps the halves: lanes 4 to 7 come before lanes 0 to 3.
COPPICE_LANES Lanes swap_halves(const Lanes& a) noexcept {
    return {
        {a.lane[4], a.lane[5], a.lane[6], a.lane[7], a.lane[0], a.lane[1], a.lane[2], a.lane[3]}};
}

/// The lanes with one of them replaced by `value`.
COPPICE_LANES Lanes with_lane(Lanes lanes, std::size_t lane, float value) noexcept {
    lanes.lane[lane] = value;
    return lanes;
}

/// One of two values, selected without a branch.
COPPICE_LANES Lanes choose(bool is_first, const Lanes& first, const Lanes& second) noexcept {
    return is_first ? first : second;
}

/// The coordinates of eight points, which are stored as x, y, z each, as one Lanes per axis.
COPPICE_LANES std::array<Lanes, 3> load_points(const std::array<const float*, 8>& points) noexcept {
    std::array<Lanes, 3> axes;
    for (std::size_t i = 0; i < 8; ++i) {
        axes[0].lane[i] = points[i][0];
        axes[1].lane[i] = points[i][1];
        axes[2].lane[i] = points[i][2];
    }
    return axes;
}

COPPICE_LANES Quad make_quad(float a, float b, float c, float d) noexcept {
    return {{a, b, c, d}};
}

/// Loads x, y, z; the fourth lane is 0. Reads nothing beyond z.
COPPICE_LANES Quad load_point(const float* point) noexcept {
    return {{point[0], point[1], point[2], 0.0F}};
}

COPPICE_LANES Quad lower_half(const Lanes& a) noexcept {
    return {{a.lane[0], a.lane[1], a.lane[2], a.lane[3]}};
}

COPPICE_LANES Quad upper_half(const Lanes& a) noexcept {
    return {{a.lane[4], a.lane[5], a.lane[6], a.lane[7]}};
}

COPPICE_LANES Lanes join(const Quad& lower, const Quad& upper) noexcept {
    return {{lower.lane[0], lower.lane[1], lower.lane[2], lower.lane[3], upper.lane[0],
             upper.lane[1], upper.lane[2], upper.lane[3]}};
}

/// A bit for every lane in which a >= b.
COPPICE_LANES unsigned greater_equal(const Quad& a, const Quad& b) noexcept {
    return bits_where(a, b, [](float x, float y) { return x >= y; });
}

/// Rotates x, y, z to y, z, x; the fourth lane stays.
COPPICE_LANES Quad of_next_axis(const Quad& a) noexcept {
    return {{a.lane[1], a.lane[2], a.lane[0], a.lane[3]}};
}

/// The sum x + y + z, added in this order.
COPPICE_LANES float sum_of_axes(const Quad& a) noexcept {
    return a.lane[0] + a.lane[1] + a.lane[2];
}

/// The first three lanes, rounded towards 0. The values must fit in an int32.
COPPICE_LANES std::array<std::uint32_t, 3> to_integers(const Quad& a) noexcept {
    std::array<std::uint32_t, 3> integers{};
    for (std::size_t i = 0; i < 3; ++i) {
        integers[i] = static_cast<std::uint32_t>(static_cast<std::int32_t>(a.lane[i]));
    }
    return integers;
}

/// The lanes, with 0 where the mask is not set.
COPPICE_LANES Lanes keep(const Mask& mask, Lanes lanes) noexcept {
    for (std::size_t i = 0; i < 8; ++i) {
        lanes.lane[i] = mask.lane[i] != 0 ? lanes.lane[i] : 0.0F;
    }
    return lanes;
}

/// Eight counters.
struct Counters {
    std::array<std::int32_t, 8> lane;
};

/// Eight counters at 0.
COPPICE_LANES Counters make_counters() noexcept {
    return {{0, 0, 0, 0, 0, 0, 0, 0}};
}

/// Increments the counters where the mask is set.
COPPICE_LANES void count(Counters& counters, const Mask& mask) noexcept {
    for (std::size_t i = 0; i < 8; ++i) {
        counters.lane[i] -= static_cast<std::int32_t>(mask.lane[i]);
    }
}

COPPICE_LANES Lanes to_lanes(const Counters& counters) noexcept {
    Lanes lanes;
    for (std::size_t i = 0; i < 8; ++i) {
        lanes.lane[i] = static_cast<float>(counters.lane[i]);
    }
    return lanes;
}

COPPICE_LANES Doubles to_doubles(const Quad& a) noexcept {
    return {{a.lane[0], a.lane[1], a.lane[2], a.lane[3]}};
}

}  // namespace coppice::inline v0::simd::scalar
