#pragma once

#include "coppice/base/timer.h"

#include <condition_variable>
#include <cstdio>
#include <mutex>
#include <optional>
#include <string>
#include <thread>

namespace coppice::lab {

/// Seconds as a person reads them: "4 s", "2:07", "1:02:07".
[[nodiscard]] std::string duration_text(double seconds);

/// The progress line: what runs, the time since the start and, if known, how long it will still
/// take; cut to `width` columns.
[[nodiscard]] std::string progress_text(const std::string& what, double elapsed_seconds,
                                        std::optional<double> remaining_seconds, int width);

/// "rendering [=====     ] 47 %", for a share in [0, 1].
[[nodiscard]] std::string bar_text(const std::string& what, double share);

/// One line on a terminal that tells what runs; redrawn every half second, wiped out by clear().
/// Where the stream is no terminal nothing is ever written. May be used by any thread, one at a
/// time.
class ProgressLine {
public:
    /// The line appears with the first show(); elapsed time counts from here.
    explicit ProgressLine(std::FILE* stream);
    ProgressLine(const ProgressLine&) = delete;
    ProgressLine& operator=(const ProgressLine&) = delete;
    ~ProgressLine();

    /// True if the stream is a terminal that can wipe a line.
    [[nodiscard]] bool is_active() const noexcept { return is_active_; }

    /// Replaces what the line says. The remaining time counts down until the next call.
    void show(const std::string& what, std::optional<double> remaining_seconds = {});

    /// Wipes the line out, so that other text can be written; the next show() brings it back.
    void clear();

private:
    void redraw_until_stopped();
    void draw();  // mutex_ is held

    std::FILE* stream_;
    bool is_active_;
    Timer timer_;
    std::mutex mutex_;
    std::condition_variable stopped_;
    bool is_stopping_ = false;
    bool is_visible_ = false;
    std::string what_;
    std::optional<double> end_seconds_;  // when the timer is expected to stand at the end
    std::thread redraw_;
};

}  // namespace coppice::lab
