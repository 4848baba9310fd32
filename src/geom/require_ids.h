#pragma once

#include "coppice/base/error.h"

#include <fmt/format.h>

#include <cstddef>
#include <limits>

namespace coppice::inline v0 {

/// Throws Error(limit) if there are more things than ids of 32 bits; the last id is for none.
inline void require_ids(std::size_t count, const char* things) {
    constexpr std::size_t most = std::numeric_limits<std::uint32_t>::max();
    if (count <= most) return;
    throw Error(ErrorCode::limit,
                fmt::format("{} {} are too many; at most {} are possible", count, things, most));
}

}  // namespace coppice::inline v0
