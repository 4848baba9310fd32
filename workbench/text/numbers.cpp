#include "text/numbers.h"

#include <fmt/format.h>

#include <cmath>
#include <cstddef>

namespace coppice::lab {

std::string seconds_text(double seconds) {
    if (seconds >= 1e6) return fmt::format("{:.3g}", seconds);
    const int digits = seconds < 0.01 ? 6 : seconds < 100.0 ? 4 : 1;
    return fmt::format("{:.{}f}", seconds, digits);
}

std::string fixed_text(const std::optional<double>& number, int decimals) {
    return number && std::isfinite(*number) ? fmt::format("{:.{}f}", *number, decimals) : "-";
}

std::string count_text(std::uint64_t count, std::string_view noun) {
    return fmt::format("{} {}{}", count, noun, count == 1 ? "" : "s");
}

std::string grouped_text(std::uint64_t number) {
    std::string digits = std::to_string(number);
    for (std::size_t at = digits.size(); at > 3;) {
        at -= 3;
        digits.insert(at, 1, ',');
    }
    return digits;
}

}  // namespace coppice::lab
