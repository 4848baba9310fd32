#pragma once

#include <string>

namespace coppice::lab {

/// Seconds for a table, "0.1234": as many digits as medians of a few runs are worth, without a
/// unit.
[[nodiscard]] std::string seconds_text(double seconds);

}  // namespace coppice::lab
