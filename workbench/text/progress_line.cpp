#include "text/progress_line.h"

#include <fmt/format.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdlib>
#include <string_view>
#include <system_error>

namespace coppice::lab {

namespace {

constexpr std::string_view wipe_line = "\r\x1b[K";

bool can_wipe_lines(std::FILE* stream) {
    const char* terminal = std::getenv("TERM");
    return isatty(fileno(stream)) == 1 && terminal != nullptr &&
           std::string_view(terminal) != "dumb";
}

int terminal_width(std::FILE* stream) {
    winsize size{};
    const bool is_known = ioctl(fileno(stream), TIOCGWINSZ, &size) == 0 && size.ws_col > 0;
    return is_known ? size.ws_col : 80;
}

}  // namespace

std::string duration_text(double seconds) {
    constexpr double longest = 360'000.0;  // longer times are shown as 100 hours
    const auto whole = static_cast<long>(std::lround(std::clamp(seconds, 0.0, longest)));
    if (whole < 60) return fmt::format("{} s", whole);
    if (whole < 3600) return fmt::format("{}:{:02}", whole / 60, whole % 60);
    return fmt::format("{}:{:02}:{:02}", whole / 3600, whole / 60 % 60, whole % 60);
}

std::string progress_text(const std::string& what, double elapsed_seconds,
                          std::optional<double> remaining_seconds, int width) {
    std::string times = " | " + duration_text(elapsed_seconds);
    if (remaining_seconds) times += ", about " + duration_text(*remaining_seconds) + " left";
    // The times stay whole; what runs is cut first.
    const auto room = static_cast<std::size_t>(std::max(width, 0));
    const std::size_t room_for_what = room > times.size() ? room - times.size() : 0;
    return (what.substr(0, room_for_what) + times).substr(0, room);
}

std::string bar_text(const std::string& what, double share) {
    constexpr std::size_t width = 20;
    std::string bar(width, ' ');
    std::fill_n(bar.begin(), static_cast<std::ptrdiff_t>(share * width), '=');
    return fmt::format("{} [{}] {} %", what, bar, static_cast<int>(100.0 * share));
}

ProgressLine::ProgressLine(std::FILE* stream, Milliseconds pause)
    : stream_(stream),
      can_wipe_(can_wipe_lines(stream)),
      pause_(can_wipe_ ? Milliseconds(500) : pause) {
    try {
        drawing_ = std::thread([this] { draw_until_stopped(); });
    } catch (const std::system_error&) {
        // The system gives no thread: the work goes on, and nobody hears how far it is.
    }
}

ProgressLine::~ProgressLine() {
    clear();
    {
        const std::lock_guard lock(mutex_);
        is_stopping_ = true;
    }
    stopped_.notify_one();
    if (drawing_.joinable()) drawing_.join();
}

void ProgressLine::show(const std::string& what, std::optional<double> remaining_seconds) {
    const std::lock_guard lock(mutex_);
    what_ = what;
    end_seconds_.reset();
    if (remaining_seconds) end_seconds_ = timer_.seconds() + *remaining_seconds;
    is_visible_ = true;
    if (can_wipe_) draw();
}

void ProgressLine::clear() {
    const std::lock_guard lock(mutex_);
    if (!is_visible_) return;
    is_visible_ = false;
    if (!can_wipe_) return;
    std::fwrite(wipe_line.data(), 1, wipe_line.size(), stream_);
    std::fflush(stream_);
}

void ProgressLine::draw_until_stopped() {
    std::unique_lock lock(mutex_);
    while (!stopped_.wait_for(lock, pause_, [this] { return is_stopping_; })) {
        if (is_visible_) draw();
    }
}

void ProgressLine::draw() {
    const double now = timer_.seconds();
    std::optional<double> remaining;
    if (end_seconds_) remaining = std::max(0.0, *end_seconds_ - now);
    std::string line;
    if (can_wipe_) {
        // One column stays free: a full line would wrap on some terminals.
        line = std::string(wipe_line) +
               progress_text(what_, now, remaining, terminal_width(stream_) - 1);
    } else {
        constexpr int uncut = 1000;
        line = "coppice: " + progress_text(what_, now, remaining, uncut) + '\n';
    }
    std::fwrite(line.data(), 1, line.size(), stream_);
    std::fflush(stream_);
}

}  // namespace coppice::lab
