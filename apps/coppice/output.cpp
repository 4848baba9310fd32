#include "output.h"

#include "coppice/base/error.h"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <string>

namespace coppice::app {

void Output::print(std::string_view text) noexcept {
    if (error_) return;
    const bool is_written =
        std::fwrite(text.data(), 1, text.size(), stdout) == text.size() && std::fflush(stdout) == 0;
    if (!is_written) error_ = {errno, std::generic_category()};
}

void Output::check() const {
    if (!error_ || error_ == std::errc::broken_pipe) return;
    throw Error(ErrorCode::io, "cannot write to standard output: " + error_.message());
}

void hold_standard_streams() noexcept {
    for (const int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO}) {
        if (fcntl(stream, F_GETFD) != -1 || errno != EBADF) continue;
        // The lowest free number is this one. Using it the usual way fails as it would without.
        if (open("/dev/null", stream == STDIN_FILENO ? O_WRONLY : O_RDONLY) != stream) return;
    }
}

void print_message(std::string_view message) noexcept {
    std::fputs("coppice: ", stderr);
    for (const char c : message) {
        const bool is_control = static_cast<unsigned char>(c) < 0x20 || c == 0x7f;
        std::fputc(is_control ? '?' : c, stderr);
    }
    std::fputc('\n', stderr);
}

}  // namespace coppice::app
