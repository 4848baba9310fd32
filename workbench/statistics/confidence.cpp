// Confidence in the mean of a few seeds. Student's t rather than the bootstrap: of three to ten
// values there is not enough to draw from again, and ratios of costs scatter much like a normal
// distribution. Source: [Student1908].

#include "statistics/confidence.h"

#include <boost/math/distributions/students_t.hpp>

#include <algorithm>
#include <cmath>

namespace coppice::lab {

double t_quantile(int degrees) {
    return boost::math::quantile(boost::math::students_t(degrees), 0.975);
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
