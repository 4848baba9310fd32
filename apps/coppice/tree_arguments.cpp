#include "tree_arguments.h"

#include "interrupts.h"
#include "options.h"
#include "rows/output_folder.h"

#include <fmt/format.h>

#include <system_error>

namespace coppice::app {

void add_tree(CLI::App& parser, std::string& tree) {
    add_text(
        parser,
        {"--tree", "FILE", "Take the tree that `coppice build -o FILE` saved for the scene", ""},
        tree);
}

void check_tree_arguments(const CLI::App& parser, const std::string& tree,
                          std::span<const std::string> scenes) {
    if (tree.empty()) return;
    for (const char* name :
         {"--method", "--sample", "--sampler", "--traversal-cost", "--intersection-cost",
          "--empty-bonus", "--expected-rays", "--memory-limit"}) {
        if (parser.count(name) == 0) continue;
        throw UsageError(fmt::format(
            "{}: has no effect on the tree that --tree loads; give only one of them", name));
    }
    if (scenes.size() > 1) {
        throw UsageError(fmt::format("--tree is the tree of one scene; leave '{}' out", scenes[1]));
    }
}

std::string_view kind_name(const AnyTree& tree) noexcept {
    return std::holds_alternative<KdTree>(tree) ? "k-d tree" : "8-wide tree";
}

void check_tree_output(const std::string& file, const std::filesystem::path& scene) {
    const std::filesystem::path path(file);
    if (path.filename().empty()) {
        throw UsageError("--out: no file is named; example: --out tree.cpk");
    }
    std::error_code problem;
    if (std::filesystem::equivalent(path, scene, problem)) {
        throw UsageError(fmt::format(
            "--out: '{}' is the scene itself and would be overwritten; example: --out tree.cpk",
            file));
    }
    const DeferInterrupts no_trace;
    lab::check_file_writable(path);
}

}  // namespace coppice::app
