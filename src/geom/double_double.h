// Double-double arithmetic: numbers as unevaluated sums of two doubles, with a precision of about
// 104 bits. It is used for the few results where the rounding of a double would show. Sums and
// products of doubles are exact. Each operation costs 10 to 20 double operations.
// Source: [Dekker1971], [Knuth1997] sec. 4.2.2 (the sum).
#pragma once

#include "coppice/geom/vec3.h"

#include <cmath>

namespace coppice::inline v0 {

/// The number high + low, where |low| is at most half a unit in the last place of high.
struct DoubleDouble {
    double high = 0.0;
    double low = 0.0;

    /// The sum of two doubles, exactly.
    [[nodiscard]] static DoubleDouble sum(double a, double b) noexcept {
        const double rounded = a + b;
        const double of_b = rounded - a;
        return {rounded, (a - (rounded - of_b)) + (b - of_b)};
    }

    /// The product of two doubles, exactly.
    [[nodiscard]] static DoubleDouble product(double a, double b) noexcept {
        const double rounded = a * b;
        return {rounded, std::fma(a, b, -rounded)};
    }

    friend DoubleDouble operator+(DoubleDouble a, DoubleDouble b) noexcept {
        const DoubleDouble high = sum(a.high, b.high);
        const DoubleDouble low = sum(a.low, b.low);
        const DoubleDouble first = sum(high.high, high.low + low.high);
        return sum(first.high, first.low + low.low);
    }

    friend DoubleDouble operator-(DoubleDouble a, DoubleDouble b) noexcept {
        return a + DoubleDouble{-b.high, -b.low};
    }

    friend DoubleDouble operator*(DoubleDouble a, DoubleDouble b) noexcept {
        const DoubleDouble high = product(a.high, b.high);
        return sum(high.high, high.low + (a.high * b.low + a.low * b.high));
    }
};

/// a - b, exactly.
[[nodiscard]] inline Vec3<DoubleDouble> exact_difference(Vec3d a, Vec3d b) noexcept {
    return {DoubleDouble::sum(a.x, -b.x), DoubleDouble::sum(a.y, -b.y),
            DoubleDouble::sum(a.z, -b.z)};
}

}  // namespace coppice::inline v0
