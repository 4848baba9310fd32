#pragma once

#include <chrono>

namespace coppice {

/// A stopwatch on the monotonic wall clock, running from its construction.
class Timer {
public:
    /// Seconds since construction or the last restart().
    [[nodiscard]] double seconds() const noexcept {
        return std::chrono::duration<double>(Clock::now() - start_).count();
    }

    void restart() noexcept { start_ = Clock::now(); }

private:
    using Clock = std::chrono::steady_clock;
    Clock::time_point start_ = Clock::now();
};

}  // namespace coppice
