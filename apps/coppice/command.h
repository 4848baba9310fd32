#pragma once

#include "interrupts.h"
#include "output.h"

#include <functional>
#include <memory>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace CLI {
class App;
}

namespace coppice::app {

/// A command of the program: its parser, and what it does once its options are read. Throws
/// UsageError for what the parser cannot see is wrong, coppice::Error for a failure.
struct Command {
    CLI::App* parser;
    std::function<void(Output&)> run;
};

/// A check that did not hold, after all that it found was printed. Exit code 1.
class CheckFailed : public std::runtime_error {
public:
    using std::runtime_error::runtime_error;
};

/// Each adds one command to the program's parser. `arguments` is the program's argument list.
[[nodiscard]] Command add_experiment(CLI::App& program, const std::vector<std::string>& arguments);
[[nodiscard]] Command add_build(CLI::App& program);
[[nodiscard]] Command add_check(CLI::App& program);
[[nodiscard]] Command add_bench(CLI::App& program);
[[nodiscard]] Command add_tune(CLI::App& program);
[[nodiscard]] Command add_compare(CLI::App& program);
[[nodiscard]] Command add_trace(CLI::App& program);
[[nodiscard]] Command add_render(CLI::App& program);
[[nodiscard]] Command add_info(CLI::App& program);
[[nodiscard]] Command add_list(CLI::App& program);
[[nodiscard]] Command add_generate(CLI::App& program);

/// A command over scenes: requires at least one, then calls `run(*request, output)`. The request
/// has `scenes`, as add_scenes() fills them in.
template <typename Request, typename Run>
[[nodiscard]] Command scene_command(CLI::App* parser, std::shared_ptr<Request> request, Run run);

/// Throws UsageError unless there is at least one scene. Those that come through pipes are taken
/// from there, see take_piped_scenes().
void require_scenes(const CLI::App& command, std::vector<std::string>& scenes);

template <typename Request, typename Run>
Command scene_command(CLI::App* parser, std::shared_ptr<Request> request, Run run) {
    return {parser, [parser, request = std::move(request), run](Output& output) {
                require_scenes(*parser, request->scenes);
                wipe_line_on_interrupt();
                run(*request, output);
            }};
}

}  // namespace coppice::app
