// Four doubles as a plain loop, for any processor; a part of lanes_scalar.h.
#pragma once

#include "simd/target.h"

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>

namespace coppice::inline v0::simd::scalar {

/// `operation` lane by lane, of any of the types below.
template <typename T, typename Operation>
COPPICE_LANES T each(T a, const T& b, const Operation& operation) noexcept {
    for (std::size_t i = 0; i < a.lane.size(); ++i) {
        a.lane[i] = operation(a.lane[i], b.lane[i]);
    }
    return a;
}

/// A bit for every lane in which a comparison holds.
template <typename T, typename Comparison>
COPPICE_LANES unsigned bits_where(const T& a, const T& b, const Comparison& holds) noexcept {
    unsigned bits = 0;
    for (unsigned i = 0; i < a.lane.size(); ++i) {
        bits |= (holds(a.lane[i], b.lane[i]) ? 1U : 0U) << i;
    }
    return bits;
}

/// Four doubles.
struct Doubles {
    std::array<double, 4> lane;
};

/// To an array aligned to 32 bytes.
COPPICE_LANES void store(const Doubles& doubles, double* to) noexcept {
    for (std::size_t i = 0; i < 4; ++i) {
        to[i] = doubles.lane[i];
    }
}

COPPICE_LANES Doubles broadcast_double(double value) noexcept {
    return {{value, value, value, value}};
}

COPPICE_LANES Doubles operator+(const Doubles& a, const Doubles& b) noexcept {
    return each(a, b, [](double x, double y) { return x + y; });
}

COPPICE_LANES Doubles operator-(const Doubles& a, const Doubles& b) noexcept {
    return each(a, b, [](double x, double y) { return x - y; });
}

COPPICE_LANES Doubles operator*(const Doubles& a, const Doubles& b) noexcept {
    return each(a, b, [](double x, double y) { return x * y; });
}

COPPICE_LANES Doubles operator-(const Doubles& a) noexcept {
    return each(a, a, [](double x, double /*same*/) { return -x; });
}

COPPICE_LANES Doubles max(const Doubles& a, const Doubles& b) noexcept {
    return each(a, b, [](double x, double y) { return x > y ? x : y; });
}

COPPICE_LANES Doubles abs(const Doubles& a) noexcept {
    return each(a, a, [](double x, double /*same*/) { return std::abs(x); });
}

/// The lanes of these numbers, in this order.
template <std::size_t i, std::size_t j, std::size_t k, std::size_t l>
COPPICE_LANES Doubles permute(const Doubles& a) noexcept {
    return {{a.lane[i], a.lane[j], a.lane[k], a.lane[l]}};
}

/// One lane.
template <std::size_t i>
COPPICE_LANES double get(const Doubles& a) noexcept {
    return a.lane[i];
}

/// The largest of all lanes; any if one is NaN.
COPPICE_LANES double greatest(const Doubles& a) noexcept {
    const Doubles pairs = max(a, permute<2, 3, 0, 1>(a));
    return pairs.lane[0] > pairs.lane[1] ? pairs.lane[0] : pairs.lane[1];
}

/// A bit for every lane in which a <= b.
COPPICE_LANES unsigned less_equal(const Doubles& a, const Doubles& b) noexcept {
    return bits_where(a, b, [](double x, double y) { return x <= y; });
}

/// As Mask, of doubles.
struct DoubleMask {
    std::array<std::uint64_t, 4> lane;
};

template <typename Comparison>
COPPICE_LANES DoubleMask compare(const Doubles& a, const Doubles& b,
                                 const Comparison& holds) noexcept {
    DoubleMask mask;
    for (std::size_t i = 0; i < 4; ++i) {
        mask.lane[i] = holds(a.lane[i], b.lane[i]) ? ~std::uint64_t{0} : 0U;
    }
    return mask;
}

COPPICE_LANES DoubleMask is_less(const Doubles& a, const Doubles& b) noexcept {
    return compare(a, b, [](double x, double y) { return x < y; });
}

COPPICE_LANES DoubleMask is_equal(const Doubles& a, const Doubles& b) noexcept {
    return compare(a, b, [](double x, double y) { return x == y; });
}

COPPICE_LANES DoubleMask operator&(const DoubleMask& a, const DoubleMask& b) noexcept {
    return each(a, b, [](auto x, auto y) { return x & y; });
}

COPPICE_LANES DoubleMask operator|(const DoubleMask& a, const DoubleMask& b) noexcept {
    return each(a, b, [](auto x, auto y) { return x | y; });
}

COPPICE_LANES Doubles select(const DoubleMask& mask, Doubles first,
                             const Doubles& second) noexcept {
    for (std::size_t i = 0; i < 4; ++i) {
        first.lane[i] = mask.lane[i] != 0 ? first.lane[i] : second.lane[i];
    }
    return first;
}

}  // namespace coppice::inline v0::simd::scalar
