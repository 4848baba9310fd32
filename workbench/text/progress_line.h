#pragma once

#include "coppice/base/timer.h"

#include <chrono>
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

/// Tells what runs. On a terminal that is one line, redrawn every half second and wiped out by
/// clear(). Elsewhere, as in a pipe, it is a new line after each pause, for as long as something is
/// shown. May be used by any thread, one at a time.
class ProgressLine {
public:
    using Milliseconds = std::chrono::milliseconds;

    /// The line appears with the first show(); elapsed time counts from here. `pause` is that
    /// between two lines where they cannot be wiped out.
    explicit ProgressLine(std::FILE* stream, Milliseconds pause = std::chrono::seconds(10));
    ProgressLine(const ProgressLine&) = delete;
    ProgressLine& operator=(const ProgressLine&) = delete;
    ~ProgressLine();

    /// Replaces what the line says. The remaining time counts down until the next call.
    void show(const std::string& what, std::optional<double> remaining_seconds = {});

    /// Wipes the line out, so that other text can be written; the next show() brings it back.
    void clear();

private:
    void draw_until_stopped();
    void draw();  // mutex_ is held

    std::FILE* stream_;
    bool can_wipe_;
    Milliseconds pause_;
    Timer timer_;
    std::mutex mutex_;
    std::condition_variable stopped_;
    bool is_stopping_ = false;
    bool is_visible_ = false;
    std::string what_;
    std::optional<double> end_seconds_;  // when the timer is expected to stand at the end
    std::thread drawing_;
};

}  // namespace coppice::lab
