#pragma once

#include "experiment/experiment_options.h"

#include <CLI/CLI.hpp>

#include <string>
#include <vector>

namespace coppice::app {

/// What an experiment is asked to do, as the parser fills it in.
struct ExperimentRequest {
    std::vector<std::string> scenes;
    std::string sampler;
    std::string out;
    std::string resume;
    std::string replay;
    double tolerance_percent = 2.0;
    lab::ExperimentOptions options;
};

/// All arguments of the command. `request` must live as long as the parser.
void add_experiment_arguments(CLI::App& parser, ExperimentRequest& request);

/// Puts together what is spread over the request. Throws UsageError for what cannot be given
/// together.
void finish_options(ExperimentRequest& request);

/// Throws UsageError naming the first option given that has no effect on this experiment.
void refuse_vain_options(const CLI::App& parser, const lab::ExperimentOptions& options);

/// Throws UsageError if any option but those named and --out is given; `why` says why not.
void refuse_other_options(const CLI::App& parser, const std::vector<std::string>& allowed,
                          const std::string& why);

}  // namespace coppice::app
