#pragma once

#include "coppice/base/error.h"

#include <fmt/format.h>

#include <cstddef>
#include <limits>

namespace coppice::inline v0 {

/// Throws Error(limit) if `count` exceeds 2^32 - 1, the number of 32-bit ids without the last one,
/// which stands for none. `things` is the plural noun for the message.
inline void require_ids(std::size_t count, const char* things) {
    constexpr std::size_t most = std::numeric_limits<std::uint32_t>::max();
    if (count <= most) return;
    throw Error(ErrorCode::limit,
                fmt::format("{} {} are too many; at most {} are possible", count, things, most));
}

}  // namespace coppice::inline v0
