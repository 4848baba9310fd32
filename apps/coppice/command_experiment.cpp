// coppice experiment: the thesis's experiment on any scenes; tables on standard output, data and
// report in a folder.

#include "coppice/build/split_finder.h"
#include "coppice/sample/sampler.h"

#include "command.h"
#include "interrupts.h"
#include "lab/experiment.h"
#include "lab/named.h"
#include "lab/output_folder.h"
#include "lab/progress_line.h"
#include "lab/protocol.h"
#include "lab/result_table.h"
#include "lab/results_document.h"
#include "lab/scene_names.h"
#include "options.h"
#include "report/make_report.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <array>
#include <limits>
#include <memory>

namespace coppice::app {

namespace {

constexpr std::array<std::string_view, 3> output_names{"results.csv", "results.json",
                                                       "report.html"};

/// The options as the parser fills them in.
struct Request {
    std::vector<std::string> scenes;
    std::string out;
    lab::ExperimentOptions options;
};

template <typename Entry>
std::vector<std::string_view> names_in(std::span<const Entry> registry) {
    std::vector<std::string_view> names;
    for (const Entry& entry : registry) {
        names.push_back(entry.name);
    }
    return names;
}

/// The names of a comma list, each of them among `names`.
std::vector<std::string> read_names(const std::string& option,
                                    const std::vector<std::string>& texts,
                                    const std::vector<std::string_view>& names) {
    std::vector<std::string> chosen =
        parse_list(option, texts, fmt::format("{}", fmt::join(names, ",")));
    for (const std::string& name : chosen) {
        require_name(option, name, names);
    }
    return chosen;
}

void add_what_to_run(CLI::App& parser, Request& request) {
    lab::ExperimentOptions& options = request.options;
    add_list_option(
        parser,
        {"--primitives", "LIST", "Trees over points, triangles or both", "points,triangles"},
        [&options](const std::vector<std::string>& texts) {
            const auto registry = lab::primitive_kind_registry();
            options.primitives.clear();
            for (const std::string& name : read_names("--primitives", texts, names_in(registry))) {
                options.primitives.push_back(
                    lab::find_named(registry, name, "kind of primitive").kind);
            }
        });
    add_list_option(
        parser, {"--protocols", "LIST", "How a tree is made from its sample", "fixed,scaled,grown"},
        [&options](const std::vector<std::string>& texts) {
            options.protocols =
                read_names("--protocols", texts, names_in(lab::protocol_registry()));
        });
    add_list_option(parser,
                    {"--rates", "LIST", "Sample sizes in percent of the primitives, in (0, 100]",
                     "100,50,40,30,20,10,5,4,3,2,1"},
                    [&options](const std::vector<std::string>& texts) {
                        options.percents = parse_percents("--rates", texts);
                    });
    add_whole(parser, {"--seeds", "N", "Repeat all with the seeds 1 to N", "1"}, options.seed_count,
              1, lab::ExperimentOptions::max_seed_count);
}

/// An option that takes one of the names in a registry.
void add_name(CLI::App& parser, const OptionText& text, std::string& value,
              const std::vector<std::string_view>& names) {
    add_text(parser, text, value)->each([option = text.name, names](const std::string& given) {
        require_name(option, given, names);
    });
}

void add_how_to_build(CLI::App& parser, BuildOptions& build) {
    constexpr double infinity = std::numeric_limits<double>::max();
    add_name(parser, {"--split", "RULE", "Where nodes are split: a rule of `coppice list`", "sah"},
             build.split.rule, names_in(split_finder_registry()));
    add_name(parser,
             {"--sampler", "NAME", "How the sample is drawn: " + lab::names_of(sampler_registry()),
              "uniform"},
             build.sample.sampler, names_in(sampler_registry()));
    add_number(parser, {"--traversal-cost", "T", "Cost of passing an inner node, >= 0", "1"},
               build.cost.traversal, {0.0, infinity, "a finite number >= 0"});
    add_number(parser, {"--intersection-cost", "T", "Cost of testing a primitive, > 0", "1"},
               build.cost.intersection, {0.0, infinity, "a finite number > 0", false});
    add_number(
        parser,
        {"--empty-bonus", "B", "Share of a split's cost taken off if one side is empty", "0.5"},
        build.cost.empty_bonus, {0.0, 1.0, "a number in [0, 1)", true, false});
    add_whole(parser, {"--max-depth", "N", "No leaf is deeper, 0 to 60", "50"},
              build.split.max_depth, 0, 60);
    add_whole(parser, {"--max-leaf", "N", "No node of so few sampled primitives is split", "32"},
              build.split.max_leaf, 1, std::numeric_limits<std::uint32_t>::max());
    add_whole(parser,
              {"--bad-refines", "N", "The N-th split on a path that does not pay is refused", "3"},
              build.split.bad_refines, 1, std::numeric_limits<int>::max());
    add_switch(parser, "--no-clip", "Cut boxes at planes instead of triangles (no perfect splits)",
               [&build] { build.split.clipping = Clipping::bounding_box; });
    add_whole(parser, {"--threads", "N", "Use at most N threads; 0 = all", "0"}, build.threads, 0,
              1024);
}

/// "dragon 12/66: triangles, grown, 20 %, seed 1"
std::string line_of(const lab::ExperimentProgress& progress) {
    if (progress.row_count == 0) return fmt::format("{}: {}", progress.scene, progress.step);
    return fmt::format("{} {}/{}: {}", progress.scene, progress.rows_done + 1, progress.row_count,
                       progress.step);
}

std::vector<lab::OutputFile> make_files(const lab::ExperimentOptions& options,
                                        std::span<const lab::SceneResult> results,
                                        const std::vector<std::string>& arguments) {
    const nlohmann::ordered_json document = lab::results_document(options, results, arguments);
    return {{std::string(output_names[0]), lab::csv_text(results)},
            {std::string(output_names[1]), document.dump(2) + '\n'},
            {std::string(output_names[2]), report::make_report(nlohmann::json(document))}};
}

void run_request(Request& request, const std::vector<std::string>& arguments, Output& output) {
    lab::ExperimentOptions& options = request.options;
    options.scenes.assign(request.scenes.begin(), request.scenes.end());
    options.out = request.out.empty() ? lab::default_output_folder(options.scenes)
                                      : std::filesystem::path(request.out);
    {
        const DeferInterrupts no_trace;
        lab::check_writable(options.out, output_names);
    }

    lab::ProgressLine progress(stderr);
    lab::ExperimentObserver observer;
    observer.on_progress = [&](const lab::ExperimentProgress& now) {
        progress.show(line_of(now), now.remaining_seconds);
    };
    observer.on_note = [&](const std::string& note) {
        progress.clear();
        print_message("note: " + note);
    };
    observer.on_scene = [&](const lab::SceneResult& scene) {
        progress.clear();
        output.print(lab::result_table(scene) + '\n');
    };
    const std::vector<lab::SceneResult> results = lab::run_experiment(options, observer);
    progress.show("writing the report");
    const std::vector<lab::OutputFile> files = make_files(options, results, arguments);
    {
        const DeferInterrupts all_or_none;
        lab::write_all(options.out, files);
    }
    progress.clear();
    for (const lab::OutputFile& file : files) {
        output.print(fmt::format("written: {}\n", (options.out / file.name).string()));
    }
}

}  // namespace

Command add_experiment(CLI::App& program, const std::vector<std::string>& arguments) {
    CLI::App* parser = program.add_subcommand(
        "experiment", "Build trees from samples of each size, and compare their costs and times");
    parser->allow_extras();
    const auto request = std::make_shared<Request>();
    add_scenes(*parser, request->scenes);
    add_what_to_run(*parser, *request);
    add_how_to_build(*parser, request->options.build);
    add_text(*parser,
             {"--out", "DIR",
              "Folder for results.csv, results.json and report.html\n"
              "[default: out/SCENE; for several scenes out/SCENE-and-N-more]",
              ""},
             request->out);
    parser->footer(
        "Examples:\n"
        "  coppice experiment scenes/dragon.obj\n"
        "  coppice experiment scenes/dragon.obj --rates 100,10,1 --seeds 5\n"
        "  coppice experiment a.obj b.ply.gz --protocols grown --primitives triangles\n"
        "The names of rules, samplers and protocols are explained by `coppice list`.");
    return {parser, [parser, request, arguments](Output& output) {
                require_scenes(*parser, request->scenes);
                wipe_line_on_interrupt();
                run_request(*request, arguments, output);
            }};
}

}  // namespace coppice::app
