#pragma once

#include "command.h"

#include <functional>

namespace coppice::app {

/// What the program ends with.
enum ExitCode { done = 0, failed = 1, wrong_use = 2 };

/// Reads a command line and hands the command that it asks for to `run`; prints help and version
/// itself. `argument_texts` begins with the program's name. Returns an ExitCode. Throws UsageError
/// for what no parser takes, Error(io) if a help text cannot be printed, and what `run` throws.
[[nodiscard]] int run_program(int argument_count, const char* const* argument_texts,
                              const std::function<void(const Command&)>& run);

}  // namespace coppice::app
