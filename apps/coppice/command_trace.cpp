// coppice trace: rays of all kinds against one tree: speed, what a ray visits, and whether every
// hit is right.

#include "coppice/builders/method.h"

#include "build_arguments.h"
#include "command.h"
#include "interrupts.h"
#include "json_file.h"
#include "options.h"
#include "text/progress_line.h"
#include "tracers/contestant.h"
#include "tree_arguments.h"
#include "verify/trace_run.h"
#include "view_arguments.h"
#include "watched_build.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <memory>

namespace coppice::app {

namespace {

/// The options as the parser fills them in.
struct TraceRequest {
    std::vector<std::string> scenes;
    MethodRequest build;
    std::string tree;
    std::string check;
    std::string json;
    lab::TraceOptions options;
};

void add_rays(CLI::App& parser, lab::TraceOptions& options) {
    const auto kinds = lab::ray_kind_registry();
    add_ray_kinds(parser, {"--rays", "LIST", listing("Kinds of rays", names_in(kinds)), "all"},
                  kinds, options.rays);
    add_whole(parser, {"--size", "N", "N x N rays of each kind: the pixels of an image", "1000"},
              options.size, 1, lab::TraceOptions::max_size);
}

lab::TraceCheck check_of(const std::string& name) {
    if (name.empty()) return lab::TraceCheck::none;
    const auto check = name == "brute" ? lab::TraceCheck::brute : lab::TraceCheck::embree;
    if (check == lab::TraceCheck::embree && lab::peer_registry().empty()) {
        throw UsageError(
            "--check: this program was built without Embree; install libembree-dev and build it "
            "again, or check with brute");
    }
    return check;
}

void fail_if_wrong(const std::vector<lab::TraceScene>& scenes) {
    std::uint64_t wrong = 0;
    std::uint64_t all = 0;
    for (const lab::TraceScene& scene : scenes) {
        for (const lab::TraceRow& row : scene.rows) {
            all += row.rays;
            wrong += row.comparison ? row.comparison->ours_wrong : 0;
        }
    }
    if (wrong > 0) throw CheckFailed(fmt::format("{} of {} rays are wrong", wrong, all));
}

void run_request(TraceRequest& request, Output& output) {
    lab::TraceOptions& options = request.options;
    options.scenes.assign(request.scenes.begin(), request.scenes.end());
    options.tree = request.tree;
    options.method = request.build.method;
    options.build = options_of(request.build);
    options.seed = request.build.seed;
    options.memory_limit_bytes = request.build.memory_limit_bytes;
    options.check = check_of(request.check);
    if (!request.json.empty()) check_json_file(request.json);

    lab::ProgressLine progress(stderr);
    bool is_first = true;
    lab::TraceObserver observer;
    observer.on_progress = [&](const std::string& step) { progress.show(step); };
    observer.on_scene = [&](const lab::TraceScene& scene) {
        progress.clear();
        note_vain_options(scene.notes, scene.method, static_cast<std::uint32_t>(scene.triangles));
        output.print((is_first ? "" : "\n") + lab::trace_text(options, scene));
        is_first = false;
    };
    const std::vector<lab::TraceScene> scenes = lab::run_trace(options, observer);
    progress.clear();
    if (!request.json.empty()) {
        write_json_file(request.json, lab::trace_document(options, scenes), output);
    }
    fail_if_wrong(scenes);
}

}  // namespace

Command add_trace(CLI::App& program) {
    CLI::App* parser = program.add_subcommand(
        "trace", "Trace rays: how fast, what they visit, and whether all hits are right");
    parser->allow_extras();
    const auto request = std::make_shared<TraceRequest>();
    add_scenes(*parser, request->scenes);
    add_rays(*parser, request->options);
    add_name(*parser,
             {"--check", "NAME",
              "Compare all hits with Embree's robust mode (embree) or with\n"
              "every triangle (brute); what differs is decided exactly",
              ""},
             request->check, {"embree", "brute"});
    add_switch(*parser, "--count", "Count nodes, leaves and primitives that rays visit",
               [request] { request->options.counts = true; });
    add_method(*parser, request->build, "Another seed, another sample and other rays");
    add_tree(*parser, request->tree);
    add_camera(*parser, request->options.camera);
    add_text(*parser, {"--json", "FILE", "Also write all figures to a file", ""}, request->json);
    parser->footer(
        "Examples:\n"
        "  coppice trace scenes/dragon.obj\n"
        "  coppice trace scenes/dragon.obj --rays axis,grazing --check embree\n"
        "  coppice build scenes/dragon.obj -o dragon.cpk\n"
        "  coppice trace scenes/dragon.obj --tree dragon.cpk\n"
        "  coppice trace scenes/*.obj --method sampled --count --json trace.json\n"
        "The names of methods and ray kinds are explained by `coppice list`.");
    return {parser, [parser, request](Output& output) {
                require_scenes(*parser, request->scenes);
                check_tree_arguments(*parser, request->tree, request->scenes);
                refuse_vain_options(*parser, request->build,
                                    {.seeds_more = true, .shows_cost = false});
                refuse_vain_view(*parser, request->options.rays);
                wipe_line_on_interrupt();
                run_request(*request, output);
            }};
}

}  // namespace coppice::app
