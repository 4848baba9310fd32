#pragma once

#include "coppice/export.h"

#include <atomic>
#include <functional>
#include <mutex>

namespace coppice::inline v0 {

/// How far a build is, for BuildControl::on_progress. Stages come one after another, each a share
/// of the whole that is known before it; what is done of a stage may be told from several threads
/// at once.
class COPPICE_EXPORT Progress {
public:
    /// Tells the listener that nothing is done yet.
    explicit Progress(std::function<void(double)> listener);

    /// All before it is done; the next stage is so much of the whole.
    void begin_stage(double share);

    /// Such a share of the stage is done, beside what was told before.
    void add(double share_of_stage);

    /// All is done.
    void finish();

private:
    void tell(double done);

    std::function<void(double)> listener_;
    double stage_begin_ = 0.0;
    double stage_share_ = 0.0;
    std::atomic<double> done_{0.0};       // of the stage
    std::atomic<double> next_told_{0.0};  // nothing less is told
    std::mutex mutex_;
};

}  // namespace coppice::inline v0
