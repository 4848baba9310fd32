#include "coppice/base/memory_meter.h"

#include <cstdio>

namespace coppice::inline v0 {

// Not from getrusage(): its figure includes the peak of the program that started this process.
std::uint64_t process_peak_bytes() noexcept {
    std::FILE* const status = std::fopen("/proc/self/status", "re");
    if (status == nullptr) return 0;
    unsigned long long kibibytes = 0;
    for (char line[256]; std::fgets(line, sizeof line, status) != nullptr;) {
        if (std::sscanf(line, "VmHWM: %llu kB", &kibibytes) == 1) break;
    }
    std::fclose(status);
    return 1024 * std::uint64_t{kibibytes};
}

}  // namespace coppice::inline v0
