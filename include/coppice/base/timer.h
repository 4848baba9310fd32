#pragma once

#include "coppice/export.h"

#include <chrono>

namespace coppice::inline v0 {

/// A stopwatch on the monotonic wall clock. Starts at construction.
class Timer {
public:
    /// Seconds since construction or the last restart().
    [[nodiscard]] double seconds() const noexcept {
        return std::chrono::duration<double>(Clock::now() - start_).count();
    }

    /// Begins again at zero.
    void restart() noexcept { start_ = Clock::now(); }

private:
    using Clock = std::chrono::steady_clock;
    Clock::time_point start_ = Clock::now();
};

/// The CPU time, in seconds, that all threads of this process have used so far, summed.
[[nodiscard]] COPPICE_EXPORT double process_cpu_seconds() noexcept;

/// A stopwatch on the CPU time of the whole process. Starts at construction.
class CpuTimer {
public:
    /// Seconds since construction or the last restart().
    [[nodiscard]] double seconds() const noexcept { return process_cpu_seconds() - start_; }

    /// Begins again at zero.
    void restart() noexcept { start_ = process_cpu_seconds(); }

private:
    double start_ = process_cpu_seconds();
};

}  // namespace coppice::inline v0
