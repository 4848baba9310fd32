// Confidence in the mean of a few seeds. Student's t rather than the bootstrap: of three to ten
// values there is not enough to draw from again, and ratios of costs scatter much like a normal
// distribution. The distribution function is a finite sum for whole degrees of freedom; its
// quantile is found by bisection. O(degrees) a step. Source: [Student1908];
// [AbramowitzStegun1964] 26.7.3 and 26.7.4 for the sums.

#include "lab/confidence.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace coppice::lab {

namespace {

/// The probability that |T| is less than t.
double probability_within(double t, int degrees) {
    const double angle = std::atan(t / std::sqrt(static_cast<double>(degrees)));
    const double cosine_squared = std::cos(angle) * std::cos(angle);
    const bool is_odd = degrees % 2 == 1;
    // 1 + 1/2 c^2 + (1 3)/(2 4) c^4 + ... for even degrees, c + 2/3 c^3 + ... for odd ones.
    double term = is_odd ? std::cos(angle) : 1.0;
    double sum = degrees == 1 ? 0.0 : term;
    for (int i = is_odd ? 3 : 2; i < degrees; i += 2) {
        term *= cosine_squared * (i - 1) / i;
        sum += term;
    }
    const double scaled = std::sin(angle) * sum;
    return is_odd ? (angle + scaled) * 2.0 / std::numbers::pi : scaled;
}

}  // namespace

double t_quantile(int degrees) {
    constexpr double confidence = 0.95;
    double low = 1.9;  // it is 1.96 for a normal distribution, and 12.7 for one degree
    double high = 13.0;
    for (int step = 0; step < 60; ++step) {
        const double middle = 0.5 * (low + high);
        (probability_within(middle, degrees) < confidence ? low : high) = middle;
    }
    return 0.5 * (low + high);
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
