// Signal handlers can only reach what is global. Of that there is one word, in a function.

#include "interrupts.h"

#include <unistd.h>

#include <atomic>
#include <csignal>

namespace coppice::app {

namespace {

struct State {
    std::atomic<bool> is_deferred{false};
    std::atomic<bool> is_second_final{false};  ///< a second interrupt is not deferred
    std::atomic<int> pending_signal{0};
};

State& state() noexcept {
    static constinit State state;
    return state;
}

void end_by(int signal) noexcept {
    constexpr char wipe_line[] = "\r\x1b[K";
    if (isatty(STDERR_FILENO) == 1) {
        // Nothing can be done about a failure here.
        [[maybe_unused]] const auto written = write(STDERR_FILENO, wipe_line, sizeof wipe_line - 1);
    }
    std::signal(signal, SIG_DFL);
    std::raise(signal);
}

extern "C" void on_interrupt(int signal) {
    const bool is_final = state().is_second_final && state().pending_signal != 0;
    if (state().is_deferred && !is_final) {
        state().pending_signal = signal;
    } else {
        end_by(signal);
    }
}

}  // namespace

void wipe_line_on_interrupt() {
    for (const int signal : {SIGINT, SIGTERM}) {
        // A shell may have asked for the signal to be ignored (`nohup`, background jobs).
        if (std::signal(signal, on_interrupt) == SIG_IGN) std::signal(signal, SIG_IGN);
    }
}

DeferInterrupts::DeferInterrupts() noexcept {
    state().is_deferred = true;
}

DeferInterrupts::~DeferInterrupts() {
    state().is_deferred = false;
    if (const int signal = state().pending_signal) end_by(signal);
}

CatchInterrupts::CatchInterrupts() noexcept {
    state().is_second_final = true;
    state().is_deferred = true;
}

CatchInterrupts::~CatchInterrupts() {
    state().is_deferred = false;
    state().is_second_final = false;
    state().pending_signal = 0;
}

bool CatchInterrupts::caught() const noexcept {
    return state().pending_signal != 0;
}

}  // namespace coppice::app
