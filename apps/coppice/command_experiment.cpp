// coppice experiment: the thesis's experiment on any scenes; tables on standard output, data and
// report in a folder.

#include "command.h"
#include "exhibits/exhibits.h"
#include "experiment/experiment.h"
#include "experiment/experiment_record.h"
#include "experiment/journal.h"
#include "experiment/result_table.h"
#include "experiment/results_document.h"
#include "experiment_arguments.h"
#include "interrupts.h"
#include "options.h"
#include "report/make_report.h"
#include "rows/machine.h"
#include "rows/output_folder.h"
#include "rows/rays_text.h"
#include "scenes/scene_names.h"
#include "text/json_text.h"
#include "text/progress_line.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <array>
#include <memory>

namespace coppice::app {

namespace {

constexpr std::array<std::string_view, 4> output_names{"results.csv", "results.json", "report.html",
                                                       "experiment.json"};

/// "dragon 12/66: triangles, grown, 20 %, seed 1"
std::string line_of(const lab::ExperimentProgress& progress) {
    if (progress.row_count == 0) return fmt::format("{}: {}", progress.scene, progress.step);
    return fmt::format("{} {}/{}: {}", progress.scene, progress.rows_done + 1, progress.row_count,
                       progress.step);
}

std::vector<lab::OutputFile> make_files(const lab::ExperimentRecord& record,
                                        std::span<const lab::SceneResult> results,
                                        std::span<const report::SceneExhibits> exhibits) {
    const lab::ExperimentOptions& options = record.options;
    const nlohmann::ordered_json document = lab::results_document(options, results, record.command);
    return {{std::string(output_names[0]), lab::csv_text(results, options.rays)},
            {std::string(output_names[1]), lab::json_text(document)},
            {std::string(output_names[2]), report::make_report(nlohmann::json(document), exhibits)},
            {std::string(output_names[3]), lab::json_text(nlohmann::json(record))}};
}

/// What the report shows beside numbers, unless it is not wanted.
std::vector<report::SceneExhibits> make_exhibits(const lab::ExperimentOptions& options,
                                                 std::span<const lab::SceneResult> results,
                                                 lab::ProgressLine& progress) {
    std::vector<report::SceneExhibits> exhibits;
    if (options.report_parts == lab::ReportParts::numbers) return exhibits;
    for (const lab::SceneResult& scene : results) {
        progress.show(scene.scene + ": pictures for the report");
        exhibits.push_back(lab::make_exhibits(scene, options, exhibits.size()));
    }
    return exhibits;
}

/// Throws UsageError if options were given that are not those of the run to be resumed.
void require_same_options(const ExperimentRequest& request, const lab::Journal& journal) {
    nlohmann::json given = request.options;
    nlohmann::json begun = journal.options();
    for (nlohmann::json* options : {&given, &begun}) {
        options->erase("out");
    }
    for (const auto& [name, value] : given.items()) {
        if (begun[name] == value) continue;
        throw UsageError(
            fmt::format("--resume: the run in {} was started with {} {}, not {}; give the same "
                        "options, or none",
                        request.resume, name, lab::json_line(begun[name]), lab::json_line(value)));
    }
}

/// The run that is to be resumed. Throws UsageError if it is not the one that the options ask for.
lab::Journal open_journal(const CLI::App& parser, const ExperimentRequest& request) {
    if (!request.out.empty() && request.out != request.resume) {
        throw UsageError("--resume writes to the folder of the run; leave --out out");
    }
    if (request.scenes.empty()) {
        refuse_other_options(parser, {"--resume"},
                             "--resume uses the options that the run was started with; give none, "
                             "or all of them and the scenes");
    }
    lab::Journal journal = lab::Journal::open(request.resume);
    if (!request.scenes.empty()) require_same_options(request, journal);
    print_message(
        fmt::format("note: {}: reusing {} finished trees", request.resume, journal.row_count()));
    return journal;
}

/// The run that begins now.
lab::Journal begin_journal(ExperimentRequest& request, const std::vector<std::string>& arguments) {
    lab::ExperimentOptions& options = request.options;
    options.out = request.out.empty() ? lab::default_output_folder(options.scenes)
                                      : std::filesystem::path(request.out);
    if (lab::Journal::exists(options.out)) {
        print_message(
            fmt::format("note: replacing the unfinished experiment in {0}; to continue it instead, "
                        "stop this run and use --resume {0}",
                        options.out.string()));
    }
    return lab::Journal::begin(options, arguments);
}

bool is_finished(const std::filesystem::path& folder) {
    std::error_code ignored;  // opening the run reports what is wrong with the name
    return !lab::Journal::exists(folder) &&
           std::filesystem::exists(folder / output_names[1], ignored);
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
    observer.find_finished = [&](const lab::TreeKey& key) { return journal.find(key); };
    observer.on_row = [&](const lab::TreeKey& key, const lab::TreeFigures& figures) {
        const DeferInterrupts whole_line;
        journal.add(key, figures);
    };
    std::size_t printed_rows = 0;  // of the current scene
    observer.on_builder = [&](const lab::SceneResult& scene) {
        progress.clear();
        output.print(lab::result_rows(scene, printed_rows));
        printed_rows = scene.rows.size();
    };
    observer.on_scene = [&](const lab::SceneResult& scene) {
        progress.clear();
        output.print(lab::result_choices(scene, options.tolerance) + '\n');
        printed_rows = 0;
        const std::string rays = lab::rays_text(scene);
        if (!rays.empty()) output.print(rays + '\n');
    };
    const std::vector<lab::SceneResult> results = lab::run_experiment(options, observer);
    const auto exhibits = make_exhibits(options, results, progress);
    progress.show("writing the report");
    const std::vector<lab::OutputFile> files = make_files(journal.record(), results, exhibits);
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

/// Takes over the options of the run that is to be run again. Throws UsageError for what does not
/// go with that, and like load_record() and require_unchanged().
void take_replayed(const CLI::App& parser, ExperimentRequest& request) {
    refuse_other_options(parser, {"--replay", "SCENE"},
                         "--replay takes all options from its file; give only --out, and the "
                         "scenes if they have moved");
    lab::ExperimentRecord record = lab::load_record(request.replay);
    if (!request.scenes.empty() && request.scenes.size() != record.contents.size()) {
        throw UsageError(fmt::format(
            "--replay: the run has {} scenes, but {} are given; give all of them, or none",
            record.contents.size(), request.scenes.size()));
    }
    if (!request.scenes.empty()) {
        record.options.scenes.assign(request.scenes.begin(), request.scenes.end());
    }
    lab::require_unchanged(record, "the run cannot be replayed");
    if (record.program_version != lab::coppice_version() ||
        record.git_revision != lab::git_revision()) {
        print_message(fmt::format(
            "note: {} was made by coppice {} ({}), and this is {} ({}): results may differ",
            request.replay, record.program_version, record.git_revision, lab::coppice_version(),
            lab::git_revision()));
    }
    if (request.out.empty()) request.out = record.options.out.string() + "-replay";
    request.options = std::move(record.options);
}

void run_request(const CLI::App& parser, ExperimentRequest& request,
                 const std::vector<std::string>& arguments, Output& output) {
    finish_options(request);
    if (!request.replay.empty()) {
        take_replayed(parser, request);
    } else if (request.resume.empty()) {
        refuse_vain_options(parser, request.options);
    }
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
    const auto request = std::make_shared<ExperimentRequest>();
    add_experiment_arguments(*parser, *request);
    parser->footer(
        "Examples:\n"
        "  coppice experiment scenes/dragon.obj\n"
        "  coppice experiment scenes/dragon.obj --rates 100,10,1 --seeds 5\n"
        "  coppice experiment scenes/*.obj --protocols grown --primitives triangles\n"
        "  coppice experiment scenes/dragon.obj --methods exact,binned,fast --rays "
        "primary,diffuse\n"
        "  coppice experiment --resume out/dragon\n"
        "  coppice experiment --replay out/dragon/experiment.json\n"
        "The names of rules, samplers, protocols, methods and ray kinds are explained by\n"
        "`coppice list`.");
    return {parser, [parser, request, arguments](Output& output) {
                const bool has_scenes = !request->resume.empty() || !request->replay.empty();
                if (!has_scenes) require_scenes(*parser, request->scenes);
                wipe_line_on_interrupt();
                run_request(*parser, *request, arguments, output);
            }};
}

}  // namespace coppice::app
