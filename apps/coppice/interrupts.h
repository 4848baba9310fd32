#pragma once

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

}  // namespace coppice::app
