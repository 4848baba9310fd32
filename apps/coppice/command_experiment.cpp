// coppice experiment: the thesis's experiment on any scenes; tables on standard output, data and
// report in a folder.

#include "coppice/build/split_finder.h"

#include "build_arguments.h"
#include "command.h"
#include "interrupts.h"
#include "lab/exhibits.h"
#include "lab/experiment.h"
#include "lab/journal.h"
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
    std::string resume;
    double tolerance_percent = 2.0;
    lab::ExperimentOptions options;
};

void add_what_to_run(CLI::App& parser, Request& request) {
    lab::ExperimentOptions& options = request.options;
    add_list_option(
        parser,
        {"--primitives", "LIST", "Trees over points, triangles or both", "points,triangles"},
        [&options](const std::vector<std::string>& texts) {
            const auto registry = lab::primitive_kind_registry();
            options.primitives.clear();
            for (const std::string& name : parse_list("--primitives", texts, "points,triangles")) {
                require_name("--primitives", name, names_in(registry));
                options.primitives.push_back(
                    lab::find_named(registry, name, "kind of primitive").kind);
            }
        });
    add_names(parser,
              {"--protocols", "LIST", "How a tree is made from its sample", "fixed,scaled,grown"},
              options.protocols, names_in(lab::protocol_registry()));
    add_list_option(parser,
                    {"--rates", "LIST", "Sample sizes in percent of the primitives, in (0, 100]",
                     "100,50,40,30,20,10,5,4,3,2,1"},
                    [&options](const std::vector<std::string>& texts) {
                        options.percents = parse_percents("--rates", texts);
                    });
    add_whole(parser, {"--seeds", "N", "Repeat all with the seeds 1 to N", "1"}, options.seed_count,
              1, lab::ExperimentOptions::max_seed_count);
    add_percentage(parser,
                   {"--tolerance", "PERCENT",
                    "What a recommended sample's tree may cost more than the full one", "2"},
                   request.tolerance_percent);
    add_switch(parser, "--no-pictures",
               "Leave pictures and tree inspector out of the report: quicker",
               [&options] { options.report_parts = lab::ReportParts::numbers; });
}

void add_how_to_build(CLI::App& parser, BuildOptions& build) {
    add_name(parser,
             {"--split", "RULE",
              listing("Where nodes are split", names_in(split_finder_registry())), "sah"},
             build.split.rule, names_in(split_finder_registry()));
    add_sampler(parser, build.sample.sampler);
    add_costs(parser, build.cost);
    add_whole(parser, {"--max-depth", "N", "No leaf is deeper, 0 to 60", "50"},
              build.split.max_depth, 0, 60);
    add_whole(parser, {"--max-leaf", "N", "No node of so few sampled primitives is split", "32"},
              build.split.max_leaf, 1, std::numeric_limits<std::uint32_t>::max());
    add_whole(parser,
              {"--bad-refines", "N", "The N-th split on a path that does not pay is refused", "3"},
              build.split.bad_refines, 1, std::numeric_limits<int>::max());
    add_switch(parser, "--no-clip", "Cut boxes at planes instead of triangles (no perfect splits)",
               [&build] { build.split.clipping = Clipping::bounding_box; });
    add_threads(parser, build.threads);
}

/// "dragon 12/66: triangles, grown, 20 %, seed 1"
std::string line_of(const lab::ExperimentProgress& progress) {
    if (progress.row_count == 0) return fmt::format("{}: {}", progress.scene, progress.step);
    return fmt::format("{} {}/{}: {}", progress.scene, progress.rows_done + 1, progress.row_count,
                       progress.step);
}

std::vector<lab::OutputFile> make_files(const lab::ExperimentOptions& options,
                                        std::span<const lab::SceneResult> results,
                                        std::span<const report::SceneExhibits> exhibits,
                                        const std::vector<std::string>& arguments) {
    const nlohmann::ordered_json document = lab::results_document(options, results, arguments);
    return {
        {std::string(output_names[0]), lab::csv_text(results)},
        {std::string(output_names[1]), document.dump(2) + '\n'},
        {std::string(output_names[2]), report::make_report(nlohmann::json(document), exhibits)}};
}

/// What the report shows beside numbers, unless it is not wanted.
std::vector<report::SceneExhibits> make_exhibits(const lab::ExperimentOptions& options,
                                                 std::span<const lab::SceneResult> results,
                                                 lab::ProgressLine& progress) {
    std::vector<report::SceneExhibits> exhibits;
    if (options.report_parts == lab::ReportParts::numbers) return exhibits;
    for (const lab::SceneResult& scene : results) {
        progress.show(scene.scene + ": pictures for the report");
        exhibits.push_back(lab::make_exhibits(scene, options));
    }
    return exhibits;
}

/// Throws UsageError if options were given that are not those of the run to be resumed.
void require_same_options(const Request& request, const lab::Journal& journal) {
    nlohmann::json given = request.options;
    nlohmann::json begun = journal.options();
    for (nlohmann::json* options : {&given, &begun}) {
        options->erase("out");
    }
    for (const auto& [name, value] : given.items()) {
        if (begun[name] == value) continue;
        throw UsageError(fmt::format(
            "--resume: the run in {} was begun with {} {}, not {}; give the same options, or none",
            request.resume, name, begun[name].dump(), value.dump()));
    }
}

/// The run that is to be resumed. Throws UsageError if it is not the one that the options ask for.
lab::Journal open_journal(const CLI::App& parser, const Request& request) {
    if (!request.out.empty() && request.out != request.resume) {
        throw UsageError("--resume: results go to the folder of the run; leave --out away");
    }
    if (request.scenes.empty()) {
        for (const CLI::Option* option : parser.get_options({})) {
            const std::string name = option->get_name();
            const bool is_own = name == "--resume" || name == "--out";
            if (option->count() == 0 || is_own) continue;
            throw UsageError(fmt::format(
                "{}: --resume goes on with the options that the run was begun with; give no "
                "others, or all of them and the scenes",
                name));
        }
    }
    lab::Journal journal = lab::Journal::open(request.resume);
    if (!request.scenes.empty()) require_same_options(request, journal);
    print_message(fmt::format("note: {}: {} finished trees are not built again", request.resume,
                              journal.row_count()));
    return journal;
}

/// The run that begins now.
lab::Journal begin_journal(Request& request, const std::vector<std::string>& arguments) {
    lab::ExperimentOptions& options = request.options;
    options.out = request.out.empty() ? lab::default_output_folder(options.scenes)
                                      : std::filesystem::path(request.out);
    if (lab::Journal::exists(options.out)) {
        print_message(
            fmt::format("note: {0} has an unfinished experiment, which is replaced; --resume {0} "
                        "goes on with it",
                        options.out.string()));
    }
    return lab::Journal::begin(options, arguments);
}

bool is_finished(const std::filesystem::path& folder) {
    return !lab::Journal::exists(folder) && std::filesystem::exists(folder / output_names[1]);
}

void run_journal(lab::Journal& journal, Output& output) {
    const lab::ExperimentOptions& options = journal.options();
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
    observer.find_finished = [&](const lab::RowKey& key) { return journal.find(key); };
    observer.on_row = [&](const lab::RowKey& key, const BuildReport& report) {
        const DeferInterrupts whole_line;
        journal.add(key, report);
    };
    observer.on_scene = [&](const lab::SceneResult& scene) {
        progress.clear();
        output.print(lab::result_table(scene, options.tolerance) + '\n');
    };
    const std::vector<lab::SceneResult> results = lab::run_experiment(options, observer);
    const auto exhibits = make_exhibits(options, results, progress);
    progress.show("writing the report");
    const std::vector<lab::OutputFile> files =
        make_files(options, results, exhibits, journal.command());
    {
        const DeferInterrupts all_or_none;
        lab::write_all(options.out, files);
        journal.remove();
    }
    progress.clear();
    for (const lab::OutputFile& file : files) {
        output.print(fmt::format("written: {}\n", (options.out / file.name).string()));
    }
}

void run_request(const CLI::App& parser, Request& request,
                 const std::vector<std::string>& arguments, Output& output) {
    request.options.tolerance = request.tolerance_percent / 100.0;
    request.options.scenes.assign(request.scenes.begin(), request.scenes.end());
    if (!request.resume.empty() && is_finished(request.resume)) {
        output.print(fmt::format("{}: the experiment is finished\n", request.resume));
        return;
    }
    lab::Journal journal =
        request.resume.empty() ? begin_journal(request, arguments) : open_journal(parser, request);
    run_journal(journal, output);
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
    add_text(*parser,
             {"--resume", "DIR", "Go on with the experiment in a folder that was cut short", ""},
             request->resume);
    parser->footer(
        "Examples:\n"
        "  coppice experiment scenes/dragon.obj\n"
        "  coppice experiment scenes/dragon.obj --rates 100,10,1 --seeds 5\n"
        "  coppice experiment a.obj b.ply.gz --protocols grown --primitives triangles\n"
        "  coppice experiment --resume out/dragon\n"
        "The names of rules, samplers and protocols are explained by `coppice list`.");
    return {parser, [parser, request, arguments](Output& output) {
                if (request->resume.empty()) require_scenes(*parser, request->scenes);
                wipe_line_on_interrupt();
                run_request(*parser, *request, arguments, output);
            }};
}

}  // namespace coppice::app
