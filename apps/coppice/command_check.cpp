// coppice check: a saved tree against its scene, as deeply as there is.

#include "coppice/base/timer.h"
#include "coppice/io/load_mesh.h"
#include "coppice/store/tree_file.h"
#include "coppice/tree/validate.h"

#include "command.h"
#include "interrupts.h"
#include "options.h"
#include "piped_scenes.h"
#include "text/json_text.h"
#include "text/progress_line.h"
#include "tree_arguments.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <memory>
#include <variant>

namespace coppice::app {

namespace {

constexpr std::size_t most_findings = 20;

/// The options as the parser fills them in.
struct CheckRequest {
    std::string tree;
    std::string scene;
    bool as_json = false;
};

/// What is known of a tree after it was checked.
struct Checked {
    SavedTree saved;
    double load_seconds = 0.0;
    std::vector<ValidationIssue> findings;
};

std::size_t node_count(const AnyTree& tree) {
    return std::visit([](const auto& any) { return any.nodes().size(); }, tree);
}

std::string check_text(const CheckRequest& request, const Checked& checked) {
    const SavedTree& saved = checked.saved;
    std::string text = fmt::format(
        "{}: {}{}{} of {} nodes, {} bytes, format version {}, loaded in {:.4f} s\n"
        "  checksums  right\n"
        "  scene      {}: the one it was built for, {} triangles\n"
        "  tree       {}\n",
        request.tree, saved.origin.method, saved.origin.method.empty() ? "" : ", ",
        kind_name(saved.tree), node_count(saved.tree), saved.file_bytes, saved.format_version,
        checked.load_seconds, request.scene, saved.primitives.primitive_count,
        checked.findings.empty() ? "sound" : "not sound:");
    for (const ValidationIssue& finding : checked.findings) {
        text += fmt::format("    {}: {}\n", name_of(finding.kind), finding.message);
    }
    return text;
}

/// Options that are no JSON are given as the text they are.
nlohmann::ordered_json options_json(const std::string& options) {
    nlohmann::ordered_json json = nlohmann::ordered_json::parse(options, nullptr, false);
    return json.is_discarded() ? nlohmann::ordered_json(options) : json;
}

std::string check_json(const CheckRequest& request, const Checked& checked) {
    const SavedTree& saved = checked.saved;
    const bool is_kd = std::holds_alternative<KdTree>(saved.tree);
    nlohmann::ordered_json json{{"tree_file", request.tree},
                                {"scene_file", request.scene},
                                {"tree", is_kd ? "kd" : "bvh8"},
                                {"method", saved.origin.method},
                                {"format_version", saved.format_version},
                                {"file_bytes", saved.file_bytes},
                                {"node_count", node_count(saved.tree)},
                                {"primitive_count", saved.primitives.primitive_count},
                                {"load_seconds", checked.load_seconds},
                                {"sound", checked.findings.empty()},
                                {"findings", nlohmann::ordered_json::array()}};
    json["options"] = options_json(saved.origin.options);
    for (const ValidationIssue& finding : checked.findings) {
        json["findings"].push_back({{"kind", name_of(finding.kind)},
                                    {"subject", finding.subject},
                                    {"message", finding.message}});
    }
    return lab::json_text(json);
}

Checked check_tree(const CheckRequest& request) {
    lab::ProgressLine progress(stderr);
    progress.show("loading " + request.scene);
    const TriangleMesh mesh = load_mesh(request.scene);
    progress.show("loading " + request.tree);
    const Timer timer;
    Checked checked{load_tree(request.tree, fingerprint_of(mesh.view())), 0.0, {}};
    checked.load_seconds = timer.seconds();
    progress.show("checking " + request.tree);
    const auto find = [&](const auto& tree) { return validate(tree, mesh.view(), most_findings); };
    checked.findings = std::visit(find, checked.saved.tree);
    return checked;
}

void run_request(const CheckRequest& request, Output& output) {
    const Checked checked = check_tree(request);
    output.print(request.as_json ? check_json(request, checked) : check_text(request, checked));
    if (checked.findings.empty()) return;
    const bool is_all = checked.findings.size() < most_findings;
    throw CheckFailed(fmt::format("{}: {}{} findings: the tree is not sound", request.tree,
                                  is_all ? "" : "at least ", checked.findings.size()));
}

void require_files(const CheckRequest& request) {
    if (!request.scene.empty()) return;
    throw UsageError(
        fmt::format("check: no {} is given; example: coppice check dragon.cpk scenes/dragon.obj",
                    request.tree.empty() ? "tree" : "scene"));
}

}  // namespace

Command add_check(CLI::App& program) {
    CLI::App* parser =
        program.add_subcommand("check", "Check a saved tree: the file, its scene, every leaf");
    parser->allow_extras();
    const auto request = std::make_shared<CheckRequest>();
    parser->add_option("TREE", request->tree)->type_name("");
    parser->add_option("SCENE", request->scene)->type_name("");
    add_switch(*parser, "--json", "Print JSON instead of text",
               [request] { request->as_json = true; });
    parser->footer(
        "Examples:\n"
        "  coppice build scenes/dragon.obj -o dragon.cpk\n"
        "  coppice check dragon.cpk scenes/dragon.obj");
    return {parser, [parser, request](Output& output) {
                require_files(*request);
                std::vector<std::string> scenes{request->scene};
                take_piped_scenes(scenes);
                request->scene = scenes.front();
                wipe_line_on_interrupt();
                run_request(*request, output);
            }};
}

}  // namespace coppice::app
