#pragma once

#include <algorithm>

namespace coppice::test {

#if defined(__SANITIZE_ADDRESS__)
inline constexpr int effort_share = 8;
#else
inline constexpr int effort_share = 1;
#endif

/// How often to do what is done `many` times elsewhere: less often under the address sanitizer,
/// which makes everything slow and finds its faults in the first few.
constexpr int effort(int many) noexcept {
    return std::max(1, many / effort_share);
}

}  // namespace coppice::test
