// Lanes as arrays and their arithmetic, for any processor. Included by lanes_scalar.h.
#pragma once

#include "simd/target.h"

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <type_traits>

namespace coppice::inline v0::simd::scalar {

/// Eight floats.
struct Lanes {
    std::array<float, 8> lane;
};

/// Four floats: half of the lanes.
struct Quad {
    std::array<float, 4> lane;
};

/// Four doubles.
struct Doubles {
    std::array<double, 4> lane;
};

/// The result of a comparison: all bits of a lane are set, or none.
struct Mask {
    std::array<std::uint32_t, 8> lane;
};

struct DoubleMask {
    std::array<std::uint64_t, 4> lane;
};

/// Applies `operation` lane by lane.
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

/// A mask of the lanes in which a comparison holds.
template <typename M, typename T, typename Comparison>
COPPICE_LANES M mask_where(const T& a, const T& b, const Comparison& holds) noexcept {
    M mask;
    for (std::size_t i = 0; i < a.lane.size(); ++i) {
        mask.lane[i] = 0;
        if (holds(a.lane[i], b.lane[i])) mask.lane[i] = ~mask.lane[i];
    }
    return mask;
}

template <typename T>
concept Register =
    std::is_same_v<T, Lanes> || std::is_same_v<T, Quad> || std::is_same_v<T, Doubles>;

template <typename T>
concept RegisterMask = std::is_same_v<T, Mask> || std::is_same_v<T, DoubleMask>;

template <Register T>
COPPICE_LANES T operator+(const T& a, const T& b) noexcept {
    return each(a, b, [](auto x, auto y) { return x + y; });
}

template <Register T>
COPPICE_LANES T operator-(const T& a, const T& b) noexcept {
    return each(a, b, [](auto x, auto y) { return x - y; });
}

template <Register T>
COPPICE_LANES T operator*(const T& a, const T& b) noexcept {
    return each(a, b, [](auto x, auto y) { return x * y; });
}

template <Register T>
COPPICE_LANES T operator-(const T& a) noexcept {
    return each(a, a, [](auto x, auto /*same*/) { return -x; });
}

/// Minimum and maximum. Where either is NaN, the result is the second argument.
template <Register T>
COPPICE_LANES T min(const T& a, const T& b) noexcept {
    return each(a, b, [](auto x, auto y) { return x < y ? x : y; });
}

template <Register T>
COPPICE_LANES T max(const T& a, const T& b) noexcept {
    return each(a, b, [](auto x, auto y) { return x > y ? x : y; });
}

template <Register T>
COPPICE_LANES T abs(const T& a) noexcept {
    return each(a, a, [](auto x, auto /*same*/) { return std::abs(x); });
}

/// A bit for every lane in which a <= b.
template <Register T>
COPPICE_LANES unsigned less_equal(const T& a, const T& b) noexcept {
    return bits_where(a, b, [](auto x, auto y) { return x <= y; });
}

COPPICE_LANES Mask is_less(const Lanes& a, const Lanes& b) noexcept {
    return mask_where<Mask>(a, b, [](float x, float y) { return x < y; });
}

COPPICE_LANES Mask is_equal(const Lanes& a, const Lanes& b) noexcept {
    return mask_where<Mask>(a, b, [](float x, float y) { return x == y; });
}

COPPICE_LANES DoubleMask is_less(const Doubles& a, const Doubles& b) noexcept {
    return mask_where<DoubleMask>(a, b, [](double x, double y) { return x < y; });
}

COPPICE_LANES DoubleMask is_equal(const Doubles& a, const Doubles& b) noexcept {
    return mask_where<DoubleMask>(a, b, [](double x, double y) { return x == y; });
}

template <RegisterMask M>
COPPICE_LANES M operator&(const M& a, const M& b) noexcept {
    return each(a, b, [](auto x, auto y) { return x & y; });
}

template <RegisterMask M>
COPPICE_LANES M operator|(const M& a, const M& b) noexcept {
    return each(a, b, [](auto x, auto y) { return x | y; });
}

/// The first value where the mask is set, else the second.
template <RegisterMask M, Register T>
COPPICE_LANES T select(const M& mask, T first, const T& second) noexcept {
    for (std::size_t i = 0; i < first.lane.size(); ++i) {
        first.lane[i] = mask.lane[i] != 0 ? first.lane[i] : second.lane[i];
    }
    return first;
}

}  // namespace coppice::inline v0::simd::scalar
