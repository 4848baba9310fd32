#pragma once

#include <optional>
#include <span>

namespace coppice::lab {

/// A mean and where the true one is with 95 % confidence.
struct Interval {
    double mean = 0.0;
    double low = 0.0;
    double high = 0.0;
};

/// How an interval is made, for those who read it.
inline constexpr const char* interval_name = "95 % t interval";

/// How many standard errors a mean of `degrees` + 1 values may be off with 95 % confidence (two
/// sides): the 0.975 quantile of Student's t distribution. `degrees` >= 1.
[[nodiscard]] double t_quantile(int degrees);

/// The mean of independent values and its 95 % t interval. Nothing for fewer than two values, and
/// where one is not finite.
[[nodiscard]] std::optional<Interval> mean_interval(std::span<const double> values);

}  // namespace coppice::lab
