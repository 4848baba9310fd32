#include "coppice/base/memory_meter.h"

#if defined(__linux__)
#include <sys/resource.h>
#endif

namespace coppice {

std::uint64_t process_peak_bytes() noexcept {
#if defined(__linux__)
    rusage usage{};
    getrusage(RUSAGE_SELF, &usage);
    constexpr std::uint64_t unit = 1024;
    return unit * static_cast<std::uint64_t>(usage.ru_maxrss);
#else
    return 0;
#endif
}

}  // namespace coppice
