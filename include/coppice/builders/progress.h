#pragma once

#include "coppice/export.h"

#include <atomic>
#include <functional>
#include <mutex>

namespace coppice::inline v0 {

/// The progress of a build, for BuildControl::on_progress. A build has stages, each with a share of
/// the whole that is known in advance. add() may be called from several threads at once.
class COPPICE_EXPORT Progress {
public:
    /// Calls `listener` with 0.
    explicit Progress(std::function<void(double)> listener);

    /// Starts a stage that is `share` of the whole. All stages before it count as done.
    void begin_stage(double share);

    /// Adds `share_of_stage` to what is done of the current stage. Calls the listener if enough has
    /// been added since its last call.
    void add(double share_of_stage);

    /// Calls the listener with 1.
    void finish();

private:
    void tell(double done);

    std::function<void(double)> listener_;
    double stage_begin_ = 0.0;
    double stage_share_ = 0.0;
    std::atomic<double> done_{0.0};       // share of the current stage
    std::atomic<double> next_told_{0.0};  // smaller values are not reported
    std::mutex mutex_;
};

}  // namespace coppice::inline v0
