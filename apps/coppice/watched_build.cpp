#include "watched_build.h"

#include "coppice/base/error.h"
#include "coppice/base/timer.h"
#include "coppice/builders/method.h"

#include "interrupts.h"
#include "output.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <condition_variable>
#include <mutex>
#include <thread>

namespace coppice::app {

namespace {

/// Hands interrupts on: a signal handler may not request a stop itself.
class InterruptWatch {
public:
    [[nodiscard]] std::stop_token token() const noexcept { return stop_.get_token(); }

    [[nodiscard]] bool caught() const noexcept { return interrupts_.caught(); }

private:
    void watch(const std::stop_token& is_over) {
        constexpr auto pause = std::chrono::milliseconds(5);
        std::mutex mutex;
        std::unique_lock lock(mutex);
        std::condition_variable_any never;
        while (!is_over.stop_requested() && !interrupts_.caught()) {
            never.wait_for(lock, is_over, pause, [] { return false; });
        }
        if (interrupts_.caught()) stop_.request_stop();
    }

    CatchInterrupts interrupts_;
    std::stop_source stop_;
    std::jthread thread_{[this](const std::stop_token& is_over) { watch(is_over); }};
};

/// Shows the share that is done, not more often than it can be read.
class ShownProgress {
public:
    ShownProgress(lab::ProgressLine& line, std::string what)
        : line_(line), what_(std::move(what)) {}

    void show(double done) {
        constexpr double pause_seconds = 0.1;
        const double now = timer_.seconds();
        if (done == 0.0) begin_ = now;
        if (done > 0.0 && done < 1.0 && now < shown_ + pause_seconds) return;
        shown_ = now;
        std::optional<double> remaining;
        // The first steps say little about the pace.
        constexpr double enough = 0.03;
        if (done >= enough) remaining = (now - begin_) * (1.0 - done) / done;
        line_.show(lab::bar_text(what_, done), remaining);
    }

private:
    lab::ProgressLine& line_;
    std::string what_;
    Timer timer_;
    double begin_ = 0.0;
    double shown_ = 0.0;
};

Interrupted interrupted() {
    return Interrupted("interrupted: the tree is not finished, nothing is written");
}

}  // namespace

void watch_build(lab::ProgressLine& progress, const std::string& what, const BuildControl& limits,
                 const std::function<void(const BuildControl&)>& build) {
    const InterruptWatch watch;
    ShownProgress shown(progress, what);
    BuildControl control = limits;
    control.stop = watch.token();
    control.on_progress = [&](double done) { shown.show(done); };
    try {
        build(control);
    } catch (const Error& error) {
        if (error.code() == ErrorCode::cancelled && watch.caught()) throw interrupted();
        throw;
    }
    if (watch.caught()) throw interrupted();  // it came too late to stop anything
}

void note_preset(const BuildReport& report) {
    if (report.preset_reason.empty()) return;
    print_message(fmt::format("note: {}; building with {} instead", report.preset_reason,
                              name_of(report.preset)));
}

void note_vain_options(std::span<const BuildNote> notes, std::string_view method,
                       std::uint32_t primitive_count) {
    if (notes.empty()) return;
    const std::vector<BuildNote> of_method =
        std::visit([&](const auto& own) { return notes_on(own, primitive_count); },
                   find_method(method).options());
    for (const BuildNote& note : notes) {
        const bool is_asked_for =
            std::find(of_method.begin(), of_method.end(), note) == of_method.end() &&
            note.option != "sample.seed";  // --seed is that of rays, too
        if (is_asked_for) print_message(fmt::format("note: {}: {}", note.option, note.reason));
    }
}

}  // namespace coppice::app
