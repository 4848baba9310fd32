// coppice bench: our methods and Embree in turns, within one process: build times, memory, rays.

#include "coppice/base/named.h"
#include "coppice/builders/method.h"

#include "bench/bench.h"
#include "build_arguments.h"
#include "command.h"
#include "interrupts.h"
#include "json_file.h"
#include "options.h"
#include "text/progress_line.h"
#include "tracers/contestant.h"
#include "view_arguments.h"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <memory>

namespace coppice::app {

namespace {

/// The options as the parser fills them in.
struct BenchRequest {
    std::vector<std::string> scenes;
    std::string json;
    lab::BenchOptions options;
};

void add_who(CLI::App& parser, lab::BenchOptions& options) {
    options.methods = {"fast"};
    for (const std::string_view name : {"embree-medium", "embree-high"}) {
        const auto available = names_in(lab::peer_registry());
        const bool is_there =
            std::find(available.begin(), available.end(), name) != available.end();
        if (is_there) options.peers.emplace_back(name);
    }
    add_names(parser,
              {"--methods", "LIST", listing("Ours", names_in(method_registry())),
               fmt::format("{}", fmt::join(options.methods, ","))},
              options.methods, names_in(method_registry()));
    if (lab::peer_registry().empty()) {
        const auto refuse = [](const std::vector<std::string>&) {
            throw UsageError(
                "--peers: this program was built without Embree; install libembree-dev and build "
                "it again");
        };
        add_list_option(parser, {"--peers", "LIST", "None: built without Embree", ""}, refuse);
        return;
    }
    add_names(parser,
              {"--peers", "LIST", listing("Of Embree", names_in(lab::peer_registry())),
               fmt::format("{}", fmt::join(options.peers, ","))},
              options.peers, names_in(lab::peer_registry()));
}

void add_how(CLI::App& parser, lab::BenchOptions& options) {
    add_list_option(parser, {"--threads", "LIST", "Measure with each of these numbers", "1,2"},
                    [&options](const std::vector<std::string>& texts) {
                        options.threads.clear();
                        for (const std::string& item : parse_list("--threads", texts, "1,2")) {
                            options.threads.push_back(
                                static_cast<int>(parse_whole("--threads", item, 1, 1024, "1,2")));
                        }
                    });
    add_whole(parser, {"--runs", "N", "Runs after the first; medians are taken", "5"}, options.runs,
              1, lab::BenchOptions::max_runs);
    add_memory_limit(parser, options.memory_limit_bytes,
                     "Fail early if scene and a build of ours would take more: 512M, 2G");
    const auto kinds = lab::rendering_ray_kinds();
    add_ray_kinds(parser,
                  {"--rays", "LIST", "Kinds of rays: " + names_of(kinds), "primary,shadow,diffuse"},
                  kinds, options.rays);
    add_switch(parser, "--batched", "Hand rays over in arrays (Embree: rtcIntersect1M)",
               [&options] { options.is_batched = true; });
}

void run_request(BenchRequest& request, Output& output) {
    lab::BenchOptions& options = request.options;
    options.scenes.assign(request.scenes.begin(), request.scenes.end());
    if (!request.json.empty()) check_json_file(request.json);

    lab::ProgressLine progress(stderr);
    lab::BenchObserver observer;
    observer.on_progress = [&](const std::string& step, std::optional<double> remaining_seconds) {
        progress.show(step, remaining_seconds);
    };
    observer.on_scene = [&](const lab::BenchScene& scene, std::span<const lab::BenchRow> rows) {
        progress.clear();
        output.print(lab::bench_table(scene, rows) + '\n');
    };
    const lab::BenchResult result = lab::run_bench(options, observer);
    progress.clear();
    if (const std::string ratios = lab::ratio_table(result.rows); !ratios.empty()) {
        output.print(ratios);
    }
    if (request.json.empty()) return;
    write_json_file(request.json, lab::bench_document(options, result), output);
}

/// True if nothing that is measured makes use of arrays of rays.
bool takes_no_arrays(const lab::BenchOptions& options) {
    return options.peers.empty() &&
           std::all_of(options.methods.begin(), options.methods.end(), [](const std::string& name) {
               return find_method(name).tree() == TreeKind::kd;
           });
}

}  // namespace

Command add_bench(CLI::App& program) {
    CLI::App* parser = program.add_subcommand(
        "bench", "Measure building and tracing, in turns with Embree where there is one");
    parser->allow_extras();
    const auto request = std::make_shared<BenchRequest>();
    add_scenes(*parser, request->scenes);
    add_who(*parser, request->options);
    add_how(*parser, request->options);
    add_measured_view(*parser, "1024", lab::BenchOptions::max_size, request->options.size,
                      request->options.camera, request->options.seed);
    add_text(*parser, {"--json", "FILE", "Also write all figures to a file", ""}, request->json);
    parser->footer(
        "Examples:\n"
        "  coppice bench scenes/dragon.obj\n"
        "  coppice bench scenes/dragon.obj --methods exact,binned --rays primary --threads 1\n"
        "  coppice bench scenes/*.obj --runs 11 --json bench.json\n"
        "The names of methods and peers are explained by `coppice list`.");
    return scene_command(parser, request, [parser](BenchRequest& given, Output& output) {
        refuse_vain(*parser, "--seed", !has_bounces(given.options.rays),
                    "it is that of diffuse rays, and --rays has none");
        refuse_vain(*parser, "--batched", takes_no_arrays(given.options),
                    "k-d methods trace the rays of an array one by one");
        run_request(given, output);
    });
}

}  // namespace coppice::app
