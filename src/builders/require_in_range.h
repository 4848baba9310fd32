#pragma once

#include "coppice/base/error.h"

#include <cstdint>
#include <string>
#include <string_view>

namespace coppice::inline v0 {

/// Throws Error(invalid_argument) with the option's name, value and range unless `holds`.
inline void require_in_range(bool holds, std::string_view name, std::int64_t value,
                             std::string_view range) {
    if (holds) return;
    throw Error(ErrorCode::invalid_argument, std::string(name) + " " + std::to_string(value) +
                                                 " is outside " + std::string(range));
}

}  // namespace coppice::inline v0
