// Confidence in the mean of a few seeds. Student's t rather than the bootstrap: of three to ten
// values there is not enough to draw from again, and ratios of costs scatter much like a normal
// distribution. Source: [Student1908].
//
// For whole degrees of freedom the distribution is a finite sum, of degrees / 2 terms, over powers
// of the cosine of atan(t / sqrt(degrees)): no library of special functions is needed for its
// quantile. Source: [AbramowitzStegun1964] 26.7.3, 26.7.4.

#include "statistics/confidence.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace coppice::lab {

namespace {

/// A function's value and its derivative.
struct Slope {
    long double value;
    long double derivative;
};

/// The probability of |t| <= sqrt(degrees) * tan(angle).
Slope probability_within(int degrees, long double angle) {
    const bool is_odd = degrees % 2 == 1;
    const long double cosine = std::cos(angle);
    long double derivative = is_odd ? 1.0L : cosine;
    long double term = is_odd ? 0.0L : 1.0L;
    long double sum = term;
    for (int k = is_odd ? 3 : 4; k <= degrees; k += 2) {
        const auto n = static_cast<long double>(k);
        derivative *= cosine * cosine * (n - 1.0L) / (n - 2.0L);
        term = k == 3 ? cosine : term * cosine * cosine * (n - 3.0L) / (n - 2.0L);
        sum += term;
    }
    const long double scale = is_odd ? 2.0L / std::numbers::pi_v<long double> : 1.0L;
    return {scale * ((is_odd ? angle : 0.0L) + std::sin(angle) * sum), scale * derivative};
}

}  // namespace

double t_quantile(int degrees) {
    constexpr long double wanted = 2.0L * 0.975 - 1.0L;
    // Newton's steps. The probability is concave in the angle, so that none goes too far until
    // rounding ends them.
    long double angle = 0.0L;
    while (true) {
        const Slope within = probability_within(degrees, angle);
        const long double next = angle + (wanted - within.value) / within.derivative;
        if (!(next > angle)) break;
        angle = next;
    }
    const auto root = std::sqrt(static_cast<long double>(degrees));
    return static_cast<double>(root * std::tan(angle));
}

std::optional<Interval> mean_interval(std::span<const double> values) {
    const bool is_finite = std::all_of(values.begin(), values.end(),
                                       [](double value) { return std::isfinite(value); });
    if (values.size() < 2 || !is_finite) return std::nullopt;
    const auto count = static_cast<double>(values.size());
    // Around the first value, so that equal values have a deviation of exactly 0.
    const double origin = values.front();
    double sum = 0.0;
    for (const double value : values) {
        sum += value - origin;
    }
    const double shift = sum / count;
    double squares = 0.0;
    for (const double value : values) {
        squares += (value - origin - shift) * (value - origin - shift);
    }
    const double mean = origin + shift;
    const double reach = t_quantile(static_cast<int>(values.size()) - 1) *
                         std::sqrt(squares / (count - 1.0) / count);
    return Interval{mean, mean - reach, mean + reach};
}

}  // namespace coppice::lab
