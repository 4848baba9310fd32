#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace coppice::lab {

/// Seconds for a table, "0.1234": as many digits as medians of a few runs are worth, without a
/// unit.
[[nodiscard]] std::string seconds_text(double seconds);

/// A number with so many decimals; "-" if there is none or it is not finite.
[[nodiscard]] std::string fixed_text(const std::optional<double>& number, int decimals);

/// A number of things: "1 thread", "2 threads".
[[nodiscard]] std::string count_text(std::uint64_t count, std::string_view noun);

/// A whole number with commas between thousands: "1,234,567".
[[nodiscard]] std::string grouped_text(std::uint64_t number);

}  // namespace coppice::lab
