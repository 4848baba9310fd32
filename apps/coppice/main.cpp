// coppice: runs the command that the arguments ask for, and turns what goes wrong into one line and
// an exit code: 0 done, 1 failed, 2 wrong use.

#include "coppice/base/error.h"

#include "interrupts.h"
#include "program.h"
#include "usage.h"

#include <fmt/format.h>

#include <csignal>
#include <new>
#include <string_view>
#include <system_error>

#if defined(__GLIBC__)
#include <malloc.h>
#endif

namespace {

/// Makes every freed array of a MiB and more leave the process: by default the limit grows to 32
/// MiB with the arrays that were freed, and a build then holds up to a third more than it uses.
void give_back_large_arrays() noexcept {
#if defined(__GLIBC__)
    mallopt(M_MMAP_THRESHOLD, 1 << 20);
#endif
}

}  // namespace

int main(int argument_count, char** arguments) {
    using namespace coppice;
    give_back_large_arrays();
    app::hold_standard_streams();
    std::signal(SIGPIPE, SIG_IGN);  // a closed pipe is a failed write, see Output
    std::signal(SIGXFSZ, SIG_IGN);  // and so is a file that may grow no further
    try {
        return app::run_program(argument_count, arguments, [](const app::Command& command) {
            app::Output output;
            command.run(output);
            output.check();
        });
    } catch (const app::UsageError& error) {
        app::print_message(error.what());
        return app::wrong_use;
    } catch (const app::CheckFailed& error) {
        app::print_message(error.what());
    } catch (const Error& error) {
        app::print_message(error.what());
    } catch (const app::Interrupted& cut_short) {
        app::print_message(cut_short.what());
    } catch (const std::bad_alloc&) {
        app::print_message(
            "out of memory: the scene and its tree do not fit; use a smaller scene or sample, or "
            "--method fast");
    } catch (const std::system_error& error) {  // a thread that the system does not give
        app::print_message(fmt::format("cannot go on: {}", error.what()));
    } catch (const std::exception& error) {
        // oneTBB's words for the same.
        const bool is_thread = std::string_view(error.what()).starts_with("pthread_create");
        app::print_message(
            fmt::format("{}: {}", is_thread ? "cannot go on" : "internal error", error.what()));
    }
    return app::failed;
}
