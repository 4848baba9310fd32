#include "builders/run_build.h"

#include "coppice/base/parallel.h"

#include <fmt/format.h>

#include <array>
#include <optional>

namespace coppice::inline v0 {

void run_watched(int threads, const BuildControl& control,
                 const std::function<void(Progress*)>& work) {
    std::optional<Progress> progress;
    if (control.on_progress) progress.emplace(control.on_progress);
    run_with_threads(
        threads, [&] { work(progress ? &*progress : nullptr); }, control.stop);
    if (progress) progress->finish();
}

bool is_within_limit(const BuildEstimate& estimate, const BuildControl& control) noexcept {
    return control.memory_limit_bytes == 0 ||
           estimate.peak_bytes + static_cast<double>(control.primitive_bytes) <=
               static_cast<double>(control.memory_limit_bytes);
}

std::string bytes_text(double bytes) {
    if (bytes == 1.0) return "1 byte";
    constexpr double step = 1024.0;
    constexpr std::array units{"bytes", "KiB", "MiB", "GiB", "TiB"};
    std::size_t unit = 0;
    while (bytes >= step && unit + 1 < units.size()) {
        bytes /= step;
        ++unit;
    }
    // Three significant digits, but whole numbers in full: "1020 MiB".
    const int decimals = unit == 0 || bytes >= 100.0 ? 0 : bytes >= 10.0 ? 1 : 2;
    return fmt::format("{:.{}f} {}", bytes, decimals, units[unit]);
}

std::string excess_text(std::string_view what, const BuildEstimate& estimate,
                        const BuildControl& control) {
    const std::string beside =
        control.primitive_bytes == 0
            ? ""
            : fmt::format(" beside the {} of its primitives",
                          bytes_text(static_cast<double>(control.primitive_bytes)));
    return fmt::format("{} would take about {} of memory{}; the limit is {}", what,
                       bytes_text(estimate.peak_bytes), beside,
                       bytes_text(static_cast<double>(control.memory_limit_bytes)));
}

}  // namespace coppice::inline v0
