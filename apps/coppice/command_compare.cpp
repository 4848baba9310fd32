// coppice compare: what two results of an experiment or a benchmark differ in beyond noise.

#include "command.h"
#include "compare/compare.h"
#include "interrupts.h"
#include "json_file.h"
#include "options.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <memory>

namespace coppice::app {

namespace {

/// The options as the parser fills them in.
struct CompareRequest {
    std::vector<std::string> files;
    std::string json;
    double tolerance_percent = 1.0;
    double time_tolerance_percent = 25.0;
};

void run_request(const CompareRequest& request, Output& output) {
    if (!request.json.empty()) check_json_file(request.json);
    const lab::CompareOptions options{request.tolerance_percent / 100.0,
                                      request.time_tolerance_percent / 100.0};
    const nlohmann::json before = lab::load_results(request.files[0]);
    const nlohmann::json after = lab::load_results(request.files[1]);
    const lab::Comparison comparison = lab::compare_results(before, after, options);
    output.print(fmt::format("A: {}\nB: {}\n{}", request.files[0], request.files[1],
                             lab::comparison_text(comparison, options)));
    if (!request.json.empty()) {
        write_json_file(request.json, lab::comparison_json(comparison, options), output);
    }
    const std::size_t worse_count = comparison.worse_count();
    if (worse_count == 0) return;
    throw CheckFailed(fmt::format("{} figure{} worse in {}", worse_count,
                                  worse_count == 1 ? " is" : "s are", request.files[1]));
}

}  // namespace

Command add_compare(CLI::App& program) {
    CLI::App* parser = program.add_subcommand(
        "compare", "Show what two results differ in beyond noise; exit code 1 if B is worse");
    parser->allow_extras();
    const auto request = std::make_shared<CompareRequest>();
    parser->add_option("A B", request->files)->type_name("");
    add_percentage(
        *parser,
        {"--tolerance", "PERCENT", "Costs, steps and bytes may differ by, without seeds", "1"},
        request->tolerance_percent);
    add_percentage(*parser, {"--time-tolerance", "PERCENT", "Times and speeds may differ by", "25"},
                   request->time_tolerance_percent);
    add_text(*parser, {"--json", "FILE", "Also write the comparison to a file", ""}, request->json);
    parser->footer(
        "A and B are files that coppice experiment or coppice bench --json wrote, or folders of "
        "an\n"
        "experiment.\n"
        "Examples:\n"
        "  coppice experiment scenes/dragon.obj\n"
        "  coppice experiment --replay out/dragon/experiment.json\n"
        "  coppice compare out/dragon/results.json out/dragon-replay/results.json\n"
        "  coppice compare out/dragon out/dragon-replay --time-tolerance 50");
    return {parser, [parser, request](Output& output) {
                if (request->files.size() != 2) {
                    throw UsageError(fmt::format(
                        "compare: two results are needed, {} given; example: coppice compare "
                        "out/a/results.json out/b/results.json",
                        request->files.size()));
                }
                run_request(*request, output);
            }};
}

}  // namespace coppice::app
