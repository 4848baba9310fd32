// coppice build: one tree by one method, and the report of how it was built.

#include "coppice/build/build_tree.h"
#include "coppice/build/estimate.h"
#include "coppice/build/method.h"
#include "coppice/io/load_mesh.h"

#include "build_arguments.h"
#include "command.h"
#include "interrupts.h"
#include "lab/build_text.h"
#include "lab/progress_line.h"
#include "lab/scene_names.h"
#include "options.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <memory>

namespace coppice::app {

namespace {

/// The options as the parser fills them in.
struct Request {
    std::vector<std::string> scenes;
    MethodRequest build;
    bool as_json = false;
};

Estimate estimate(const Method& method, const BuildOptions& options, const TriangleMesh& mesh) {
    return method.tree == TreeKind::kd ? estimate_kd_tree(mesh.view(), options)
                                       : estimate_wide_bvh(mesh.view(), options);
}

BuildReport build(const Method& method, const BuildOptions& options, const TriangleMesh& mesh) {
    BuildReport report;
    if (method.tree == TreeKind::kd) {
        static_cast<void>(build_kd_tree(mesh.view(), options, &report));
    } else {
        static_cast<void>(build_wide_bvh(mesh.view(), options, &report));
    }
    report.method = method.name;
    return report;
}

void run_request(const Request& request, Output& output) {
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
        const Estimate expected = estimate(method, options, mesh);
        progress.show(names[i] + ": building", expected.seconds);
        BuildReport report = build(method, options, mesh);
        report.estimate = expected;
        progress.clear();
        if (request.as_json) {
            scenes.push_back({{"scene", names[i]}, {"file", request.scenes[i]}});
            scenes.back()["report"] = nlohmann::json(report);
        } else {
            const char* tree = method.tree == TreeKind::kd ? "k-d tree" : "8-wide tree";
            output.print((i == 0 ? "" : "\n") + lab::build_text(names[i], tree, report));
        }
    }
    if (request.as_json) {
        // File names need not be UTF-8; JSON must be.
        const nlohmann::ordered_json document{{"scenes", scenes}};
        output.print(
            document.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace) + '\n');
    }
}

}  // namespace

Command add_build(CLI::App& program) {
    CLI::App* parser =
        program.add_subcommand("build", "Build a tree and show what it took and what it is like");
    parser->allow_extras();
    const auto request = std::make_shared<Request>();
    add_scenes(*parser, request->scenes);
    add_method(*parser, request->build, "Same seed, same sample");
    add_switch(*parser, "--json", "Print JSON instead of text",
               [request] { request->as_json = true; });
    parser->footer(
        "Examples:\n"
        "  coppice build scenes/dragon.obj\n"
        "  coppice build scenes/dragon.obj --method sampled --sample 0.1%\n"
        "  coppice build a.obj b.ply.gz --method exact --threads 1 --json\n"
        "The names of methods and samplers are explained by `coppice list`.");
    return {parser, [parser, request](Output& output) {
                require_scenes(*parser, request->scenes);
                wipe_line_on_interrupt();
                run_request(*request, output);
            }};
}

}  // namespace coppice::app
