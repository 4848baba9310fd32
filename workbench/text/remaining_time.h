#pragma once

#include <algorithm>
#include <optional>

namespace coppice::lab {

/// How long planned work will still take, judged by the work done so far.
class RemainingTime {
public:
    /// Adds work to be done.
    void plan(double work) noexcept { planned_ += work; }

    /// Records that some of the planned work took `seconds`.
    void finish(double work, double seconds) noexcept {
        done_ += work;
        seconds_ += seconds;
    }

    /// Seconds of the work that is left; nothing while none is done.
    [[nodiscard]] std::optional<double> seconds() const noexcept {
        if (!(done_ > 0.0)) return std::nullopt;
        return seconds_ / done_ * std::max(0.0, planned_ - done_);
    }

private:
    double planned_ = 0.0;
    double done_ = 0.0;
    double seconds_ = 0.0;
};

}  // namespace coppice::lab
