// coppice build: one tree by one method, the report of how it was built, and the tree as a file.

#include "coppice/base/memory_meter.h"
#include "coppice/builders/build_tree.h"
#include "coppice/builders/estimate.h"
#include "coppice/builders/method.h"
#include "coppice/io/load_mesh.h"
#include "coppice/json/build_options.h"
#include "coppice/json/build_report.h"
#include "coppice/store/tree_file.h"

#include "build_arguments.h"
#include "command.h"
#include "interrupts.h"
#include "options.h"
#include "scenes/scene_names.h"
#include "text/build_text.h"
#include "text/json_text.h"
#include "text/progress_line.h"
#include "tracers/memory_limit.h"
#include "tracers/traced_tree.h"
#include "tree_arguments.h"
#include "watched_build.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <memory>
#include <variant>

namespace coppice::app {

namespace {

/// The options as the parser fills them in.
struct BuildRequest {
    std::vector<std::string> scenes;
    MethodRequest build;
    std::string out;
    bool as_json = false;
};

BuildEstimate estimate(const BuildOptions& options, const TriangleMesh& mesh,
                       const std::stop_token& stop) {
    if (const auto* const kd = std::get_if<KdOptions>(&options)) {
        return estimate_kd_tree(mesh.view(), *kd, stop);
    }
    return estimate_bvh8(mesh.view(), std::get<Bvh8Options>(options), stop);
}

/// Builds, and reports what was expected; with a memory limit the library does the latter.
lab::AnyBuild build(const Method& method, const BuildOptions& options, const TriangleMesh& mesh,
                    const BuildControl& control) {
    std::optional<BuildEstimate> expected;
    if (control.memory_limit_bytes == 0) expected = estimate(options, mesh, control.stop);
    lab::AnyBuild built = lab::build_tree(mesh.view(), options, control);
    built.report.method = method.name;
    if (expected) built.report.estimate = expected;
    return built;
}

/// The number of threads is left out: the tree does not depend on it, nor does its file.
TreeOrigin origin_of(const BuildReport& report) {
    nlohmann::json options = report.options;
    options.erase("threads");
    return {report.method, options.dump()};
}

void save(const std::string& file, const AnyTree& tree, const TriangleMesh& mesh,
          const BuildReport& report) {
    const Fingerprint primitives = fingerprint_of(mesh.view());
    const TreeOrigin origin = origin_of(report);
    const DeferInterrupts whole_file;
    std::visit([&](const auto& any) { save_tree(file, any, primitives, origin); }, tree);
}

void run_request(const BuildRequest& request, Output& output) {
    const Method& method = find_method(request.build.method);
    const BuildOptions options = options_of(request.build);
    const std::vector<std::filesystem::path> files(request.scenes.begin(), request.scenes.end());
    const std::vector<std::string> names = lab::scene_names(files);
    auto scenes = nlohmann::ordered_json::array();
    for (std::size_t i = 0; i < files.size(); ++i) {
        lab::ProgressLine progress(stderr);
        progress.show(names[i] + ": loading");
        const TriangleMesh mesh = load_mesh(files[i]);
        progress.show(names[i] + ": estimating");
        lab::AnyBuild built;
        watch_build(
            progress, names[i] + ": building",
            lab::limit_memory(request.build.memory_limit_bytes, mesh.view()),
            [&](const BuildControl& control) { built = build(method, options, mesh, control); });
        const auto& [tree, report] = built;
        if (!request.out.empty()) {
            progress.show(names[i] + ": writing");
            save(request.out, tree, mesh, report);
        }
        progress.clear();
        note_preset(report);
        const std::uint64_t scene_bytes = lab::byte_count(mesh.view());
        if (request.as_json) {
            scenes.push_back({{"scene", names[i]}, {"file", request.scenes[i]}});
            if (!request.out.empty()) scenes.back()["output"] = request.out;
            scenes.back()["scene_bytes"] = scene_bytes;
            scenes.back()["process_peak_bytes"] = process_peak_bytes();
            scenes.back()["report"] = nlohmann::json(report);
        } else {
            const std::string kind(kind_name(tree));
            output.print((i == 0 ? "" : "\n") + lab::build_text(names[i], kind, report) +
                         lab::process_text(scene_bytes, report.peak_bytes, process_peak_bytes()));
            if (!request.out.empty()) output.print(fmt::format("written: {}\n", request.out));
        }
    }
    if (request.as_json) {
        output.print(lab::json_text(nlohmann::ordered_json{{"scenes", scenes}}));
    }
}

void check_output(const BuildRequest& request) {
    if (request.out.empty()) return;
    if (request.scenes.size() > 1) {
        throw UsageError(fmt::format(
            "--out takes the tree of one scene; leave '{}' out, or build it in a run of its own",
            request.scenes[1]));
    }
    check_tree_output(request.out, request.scenes.front());
}

}  // namespace

Command add_build(CLI::App& program) {
    CLI::App* parser =
        program.add_subcommand("build", "Build a tree and show what it took and what it is like");
    parser->allow_extras();
    const auto request = std::make_shared<BuildRequest>();
    add_scenes(*parser, request->scenes);
    add_text(*parser, {"-o,--out", "FILE", "Save the tree, for trace, render and check", ""},
             request->out);
    add_method(*parser, request->build, "Same seed, same sample");
    add_switch(*parser, "--json", "Print JSON instead of text",
               [request] { request->as_json = true; });
    parser->footer(
        "Examples:\n"
        "  coppice build scenes/dragon.obj\n"
        "  coppice build scenes/dragon.obj --method sampled --sample 0.1%\n"
        "  coppice build scenes/dragon.obj -o dragon.cpk\n"
        "  coppice build scenes/*.obj --method exact --threads 1 --json\n"
        "The names of methods and samplers are explained by `coppice list`.");
    return scene_command(parser, request, [parser](const BuildRequest& given, Output& output) {
        refuse_vain_options(*parser, given.build, {});
        check_output(given);
        run_request(given, output);
    });
}

}  // namespace coppice::app
