#pragma once

#include <stdexcept>

namespace coppice::app {

/// From now on Ctrl-C (SIGINT) and SIGTERM wipe the progress line before they end the program the
/// usual way: a shell sees exit code 130 or 143.
void wipe_line_on_interrupt();

/// While one lives, an interrupt waits: files are being written, all or none. One at a time.
class DeferInterrupts {
public:
    DeferInterrupts() noexcept;
    DeferInterrupts(const DeferInterrupts&) = delete;
    DeferInterrupts& operator=(const DeferInterrupts&) = delete;

    /// Ends the program if it was interrupted meanwhile.
    ~DeferInterrupts();
};

/// While one lives, the first interrupt only shows in caught(), so that work can be cut short; a
/// second one ends the program. Not together with a DeferInterrupts.
class CatchInterrupts {
public:
    CatchInterrupts() noexcept;
    CatchInterrupts(const CatchInterrupts&) = delete;
    CatchInterrupts& operator=(const CatchInterrupts&) = delete;

    /// Forgets the interrupt.
    ~CatchInterrupts();

    /// May be asked by any thread.
    [[nodiscard]] bool caught() const noexcept;
};

/// Work that was cut short by an interrupt, after what there was of it is safe. Exit code 1.
class Interrupted : public std::runtime_error {
public:
    using std::runtime_error::runtime_error;
};

}  // namespace coppice::app
