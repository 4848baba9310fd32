// Four doubles as an array, for any processor. Included by lanes_scalar.h.
#pragma once

#include "simd/registers_scalar.h"
#include "simd/target.h"

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>

namespace coppice::inline v0::simd::scalar {

/// Stores to an array aligned to 32 bytes.
COPPICE_LANES void store(const Doubles& doubles, double* to) noexcept {
    for (std::size_t i = 0; i < 4; ++i) {
        to[i] = doubles.lane[i];
    }
}

COPPICE_LANES Doubles broadcast_double(double value) noexcept {
    return {{value, value, value, value}};
}

/// The lanes with these indices, in this order.
template <std::size_t i, std::size_t j, std::size_t k, std::size_t l>
COPPICE_LANES Doubles permute(const Doubles& a) noexcept {
    return {{a.lane[i], a.lane[j], a.lane[k], a.lane[l]}};
}

/// The value of lane i.
template <std::size_t i>
COPPICE_LANES double get(const Doubles& a) noexcept {
    return a.lane[i];
}

/// The largest of all lanes; unspecified if one is NaN.
COPPICE_LANES double greatest(const Doubles& a) noexcept {
    const Doubles pairs = max(a, permute<2, 3, 0, 1>(a));
    return pairs.lane[0] > pairs.lane[1] ? pairs.lane[0] : pairs.lane[1];
}

}  // namespace coppice::inline v0::simd::scalar
