#pragma once

#include <string_view>
#include <system_error>

namespace coppice::app {

/// Standard output. A reader that has gone away (`coppice list | head -1`) is no failure, and no
/// failure to print ends the work that is still to do.
class Output {
public:
    /// Writes and flushes; after a failure it does nothing.
    void print(std::string_view text) noexcept;

    /// Throws Error(io) if something could not be written, unless the reader closed the pipe.
    void check() const;

private:
    std::error_code error_;
};

/// Keeps the numbers of standard streams that are closed from files that are opened later: what is
/// printed would be written into them.
void hold_standard_streams() noexcept;

/// Writes `coppice: message` to standard error as one line, control characters replaced.
void print_message(std::string_view message) noexcept;

}  // namespace coppice::app
