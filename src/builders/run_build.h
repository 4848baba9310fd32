#pragma once

#include "coppice/builders/build_control.h"
#include "coppice/builders/build_options.h"
#include "coppice/builders/build_report.h"
#include "coppice/builders/progress.h"

#include <functional>
#include <string>
#include <string_view>

namespace coppice::inline v0 {

/// Runs a build as its options and control say: checks the options, and tells `control` of the
/// progress; `build` gets null if nobody asks for it. Throws Error(cancelled) after a stop.
void run_build(const BuildOptions& options, const BuildControl& control,
               const std::function<void(Progress*)>& build);

/// The next stage of a build, if anybody asks; see Progress.
inline void begin_stage(Progress* progress, double share) {
    if (progress != nullptr) progress->begin_stage(share);
}

/// True if a build keeps within the limit, or there is none.
[[nodiscard]] bool is_within_limit(const BuildEstimate& estimate,
                                   const BuildControl& control) noexcept;

/// "1.5 GiB": bytes as people read them.
[[nodiscard]] std::string bytes_text(double bytes);

/// "WHAT would take about 1.5 GiB of memory beside 200 MiB of primitives; the limit is 1 GiB".
[[nodiscard]] std::string excess_text(std::string_view what, const BuildEstimate& estimate,
                                      const BuildControl& control);

}  // namespace coppice::inline v0
