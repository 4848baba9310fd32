// coppice tune: which builder and rate to use for a number of rays, measured on the scene itself.

#include "coppice/base/named.h"
#include "coppice/builders/method.h"

#include "build_arguments.h"
#include "command.h"
#include "interrupts.h"
#include "json_file.h"
#include "options.h"
#include "text/progress_line.h"
#include "tune/tune.h"
#include "view_arguments.h"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <nlohmann/json.hpp>

#include <limits>
#include <memory>

namespace coppice::app {

namespace {

/// The options as the parser fills them in.
struct TuneRequest {
    std::vector<std::string> scenes;
    std::string json;
    lab::TuneOptions options;
};

void add_what_to_measure(CLI::App& parser, lab::TuneOptions& options) {
    add_number(parser, {"--rays", "N", "Rays that will be traced with the tree", "1e8"},
               options.ray_count,
               {1.0, std::numeric_limits<double>::max(), "a finite number >= 1"});
    add_names(parser,
              {"--methods", "LIST", listing("To choose from", names_in(method_registry())),
               fmt::format("{}", fmt::join(options.methods, ","))},
              options.methods, names_in(method_registry()));
    add_list_option(parser,
                    {"--rates", "LIST",
                     "Sample sizes in percent, in (0, 100], for methods that sample", "1,10,100"},
                    [&options](const std::vector<std::string>& texts) {
                        options.percents = parse_percents("--rates", texts);
                    });
    const auto kinds = lab::rendering_ray_kinds();
    add_ray_kinds(
        parser, {"--kinds", "LIST", "Kinds of rays: " + names_of(kinds), "primary,shadow,diffuse"},
        kinds, options.rays);
}

void add_how_to_measure(CLI::App& parser, lab::TuneOptions& options) {
    add_whole(parser, {"--threads", "N", "Build and trace on N threads; 0 = all", "0"},
              options.threads, 0, 1024);
    add_whole(parser, {"--runs", "N", "Runs after the first; medians are taken", "3"}, options.runs,
              1, lab::BenchOptions::max_runs);
    add_memory_limit(parser, options.memory_limit_bytes,
                     "Fail early if scene and build would take more: 512M, 2G");
    add_measured_view(parser, "512", lab::BenchOptions::max_size, options.size, options.camera,
                      options.seed);
}

void run_request(TuneRequest& request, Output& output) {
    lab::TuneOptions& options = request.options;
    options.scenes.assign(request.scenes.begin(), request.scenes.end());
    if (!request.json.empty()) check_json_file(request.json);
    lab::ProgressLine progress(stderr);
    const std::vector<lab::TuneResult> results = lab::run_tune(
        options, [&](const std::string& step, std::optional<double> remaining_seconds) {
            progress.show(step, remaining_seconds);
        });
    progress.clear();
    for (const lab::TuneResult& result : results) {
        output.print(lab::tune_table(options, result) + '\n');
    }
    for (const lab::TuneResult& result : results) {
        output.print(lab::tune_sentence(options, result) + '\n');
    }
    if (request.json.empty()) return;
    write_json_file(request.json, lab::tune_document(options, results), output);
}

bool has_sampling_method(const lab::TuneOptions& options) {
    return std::any_of(options.methods.begin(), options.methods.end(),
                       [](const std::string& name) { return find_method(name).uses_sample(); });
}

}  // namespace

Command add_tune(CLI::App& program) {
    CLI::App* parser = program.add_subcommand(
        "tune", "Tell which builder and rate to use for a number of rays, and why");
    parser->allow_extras();
    const auto request = std::make_shared<TuneRequest>();
    add_scenes(*parser, request->scenes);
    add_what_to_measure(*parser, request->options);
    add_how_to_measure(*parser, request->options);
    add_text(*parser, {"--json", "FILE", "Also write all figures to a file", ""}, request->json);
    parser->footer(
        "Examples:\n"
        "  coppice tune scenes/dragon.obj --rays 1e8\n"
        "  coppice tune scenes/dragon.obj --rays 1e6 --methods fast,quality --rates 0.5,1,100\n"
        "  coppice tune scenes/dragon.obj --eye=-0.1,0.2,0.4 --look-at=0,0.1,0 --json tune.json\n"
        "The names of methods are explained by `coppice list`.");
    return scene_command(parser, request, [parser](TuneRequest& given, Output& output) {
        refuse_vain(*parser, "--seed", !has_bounces(given.options.rays),
                    "it is that of diffuse rays, and --kinds has none");
        refuse_vain(*parser, "--rates", !has_sampling_method(given.options),
                    "none of --methods takes a sample");
        run_request(given, output);
    });
}

}  // namespace coppice::app
