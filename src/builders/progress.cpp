#include "coppice/builders/progress.h"

#include <algorithm>
#include <utility>

namespace coppice::inline v0 {
namespace {

constexpr double told_step = 1e-3;

}  // namespace

Progress::Progress(std::function<void(double)> listener) : listener_(std::move(listener)) {
    tell(0.0);
}

void Progress::begin_stage(double share) {
    stage_begin_ += stage_share_;
    stage_share_ = share;
    done_ = 0.0;
    add(0.0);
}

void Progress::add(double share_of_stage) {
    const double of_stage = done_.fetch_add(share_of_stage) + share_of_stage;
    // Stays below 1, which finish() reports.
    const double done =
        std::min(stage_begin_ + stage_share_ * std::min(of_stage, 1.0), 1.0 - told_step);
    if (done < next_told_) return;
    // If another thread is reporting, its value is nearly the same, and this one is dropped.
    const std::unique_lock lock(mutex_, std::try_to_lock);
    if (lock && done >= next_told_) tell(done);
}

void Progress::finish() {
    tell(1.0);
}

void Progress::tell(double done) {
    next_told_ = done + told_step;
    listener_(done);
}

}  // namespace coppice::inline v0
