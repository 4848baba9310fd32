#pragma once

#include "coppice/base/timer.h"
#include "coppice/builders/build_report.h"

namespace coppice::inline v0 {

/// Measures the times of the stages of a build one after another. Starts at construction.
class StageClock {
public:
    /// Ends a stage with `items` results, returns its report, and starts the next stage.
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
