#pragma once

#include "coppice/build/build_options.h"

#include <CLI/CLI.hpp>

#include <optional>
#include <string>

namespace coppice::app {

/// The options of a build that several commands have. Each fills in what is given and leaves the
/// rest as it is.

/// --traversal-cost, --intersection-cost and --empty-bonus.
void add_costs(CLI::App& parser, SahCostModel& cost);

/// --sampler.
CLI::Option* add_sampler(CLI::App& parser, std::string& sampler);

/// --method; the default is the library's.
void add_method(CLI::App& parser, std::string& method);

/// --sample, the share that the method would choose otherwise.
void add_sample(CLI::App& parser, std::optional<double>& rate);

/// --threads.
void add_threads(CLI::App& parser, int& threads);

}  // namespace coppice::app
