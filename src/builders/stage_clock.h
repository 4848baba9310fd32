#pragma once

#include "coppice/base/timer.h"
#include "coppice/builders/build_report.h"

namespace coppice::inline v0 {

/// Times the stages of a build one after another; runs from its construction.
class StageClock {
public:
    /// Ends a stage that `items` came out of, and begins the next.
    [[nodiscard]] StageReport lap(std::uint64_t items) noexcept {
        const StageReport stage{wall_.seconds(), cpu_.seconds(), items};
        wall_.restart();
        cpu_.restart();
        return stage;
    }

private:
    Timer wall_;
    CpuTimer cpu_;
};

}  // namespace coppice::inline v0
