#include "text/seconds_text.h"

#include <fmt/format.h>

namespace coppice::lab {

std::string seconds_text(double seconds) {
    if (seconds >= 1e6) return fmt::format("{:.3g}", seconds);
    const int digits = seconds < 0.01 ? 6 : seconds < 100.0 ? 4 : 1;
    return fmt::format("{:.{}f}", seconds, digits);
}

}  // namespace coppice::lab
