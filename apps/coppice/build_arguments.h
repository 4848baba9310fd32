#pragma once

#include "coppice/build/build_options.h"

#include <CLI/CLI.hpp>

#include <string>

namespace coppice::app {

/// The options of a build that several commands have. Each fills in what is given and leaves the
/// rest as it is.

/// --traversal-cost, --intersection-cost and --empty-bonus.
void add_costs(CLI::App& parser, SahCostModel& cost);

/// --sampler.
CLI::Option* add_sampler(CLI::App& parser, std::string& sampler);

/// --threads.
void add_threads(CLI::App& parser, int& threads);

}  // namespace coppice::app
