#include "coppice/builders/progress.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace coppice::inline v0 {
namespace {

constexpr double told_step = 1e-3;

// What is left to do for so many PrimRefs, in passes over them: one for each level where nodes are
// large, and the rest in the cache. That it is 20 passes for the rest is an average of the methods.
double work_below(std::size_t count) noexcept {
    constexpr double small_node = 4096.0;
    constexpr double small_passes = 20.0;
    const auto n = static_cast<double>(count);
    return n * (small_passes + std::max(0.0, std::log2(n / small_node)));
}

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
    // Not quite 1: that is for the end.
    const double done =
        std::min(stage_begin_ + stage_share_ * std::min(of_stage, 1.0), 1.0 - told_step);
    if (done < next_told_) return;
    // Whoever else is telling tells nearly as much.
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

NodeShares divide_share(double share, std::size_t count, std::size_t below,
                        std::size_t above) noexcept {
    if (share == 0.0) return {};
    const auto own = static_cast<double>(count);
    const double of_below = work_below(below);
    const double of_above = work_below(above);
    const double unit = share / (own + of_below + of_above);
    return {unit * own, unit * of_below, unit * of_above};
}

}  // namespace coppice::inline v0
