#include "text/build_text.h"

#include <fmt/format.h>

#include <string_view>

namespace coppice::lab {

namespace {

constexpr const char* stage_format = "  {:<8} {:>10} {:>10} {:>12} {}\n";

std::string stage_seconds(double seconds) {
    return fmt::format("{:.6f}", seconds);
}

std::string stage_text(std::string_view name, const StageReport& stage, std::string_view items) {
    return fmt::format(stage_format, name, stage_seconds(stage.wall_seconds),
                       stage_seconds(stage.cpu_seconds), stage.items, items);
}

std::string stages_text(const StageReports& stages) {
    return fmt::format(stage_format, "stage", "wall s", "CPU s", "items", "") +
           stage_text("sample", stages.sample, "primitives") +
           stage_text("build", stages.build, "nodes of the sampled tree") +
           stage_text("empty", stages.empty, "nodes kept") +
           stage_text("refill", stages.refill, "references") +
           stage_text("refine", stages.refine, "references") +
           fmt::format("  {:<8} {:>10} {:>10}\n", "total", stage_seconds(stages.wall_seconds()),
                       stage_seconds(stages.cpu_seconds()));
}

std::string tree_text(const BuildReport& report) {
    const TreeStatistics& tree = report.statistics;
    const SahCostModel& cost = cost_of(report.options);
    return fmt::format(
        "  tree     {} nodes, {} leaves ({} empty), {} levels, {} references\n"
        "  cost     {:.4f}, by traversal {} and intersection {}: {:.2f} inner nodes, {:.2f} "
        "leaves, "
        "{:.2f} primitives a ray\n",
        tree.node_count, tree.leaf_count, tree.empty_leaf_count, tree.max_level,
        tree.reference_count, tree.sah_cost, cost.traversal, cost.intersection,
        tree.expected_inner_visits, tree.expected_leaf_visits, tree.expected_primitive_tests);
}

std::string memory_text(const BuildReport& report) {
    const double count = report.primitive_count > 0 ? report.primitive_count : 1.0;
    return fmt::format(
        "  memory   {} bytes kept ({:.1f} a primitive), {} at most while building ({:.1f} a "
        "primitive)\n",
        report.tree_bytes, static_cast<double>(report.tree_bytes) / count, report.peak_bytes,
        static_cast<double>(report.peak_bytes) / count);
}

std::string estimate_line(std::string_view name, double estimate, double found,
                          const char* format) {
    const std::string off =
        found > 0.0 ? fmt::format("{:+.1f} %", 100.0 * (estimate / found - 1.0)) : "-";
    return fmt::format("  {:<14} {:>14} {:>14} {:>9}\n", name,
                       fmt::format(fmt::runtime(format), estimate),
                       fmt::format(fmt::runtime(format), found), off);
}

std::string estimate_text(const BuildReport& report) {
    if (!report.estimate) return {};
    const BuildEstimate& estimate = *report.estimate;
    return fmt::format("  {:<14} {:>14} {:>14} {:>9}\n", "", "estimated", "found", "off") +
           estimate_line("references", estimate.references,
                         static_cast<double>(report.statistics.reference_count), "{:.0f}") +
           estimate_line("bytes kept", estimate.bytes, static_cast<double>(report.tree_bytes),
                         "{:.0f}") +
           estimate_line("bytes at most", estimate.peak_bytes,
                         static_cast<double>(report.peak_bytes), "{:.0f}") +
           estimate_line("wall seconds", estimate.seconds, report.stages.wall_seconds(), "{:.4f}");
}

std::string notes_text(const BuildReport& report) {
    std::string text;
    for (const BuildNote& note : report.notes) {
        text += fmt::format("  note     {}: {}\n", note.option, note.reason);
    }
    return text;
}

}  // namespace

std::string build_text(const std::string& scene, const std::string& tree,
                       const BuildReport& report) {
    const auto* const bvh8 = std::get_if<Bvh8Options>(&report.options);
    const bool is_chosen = bvh8 != nullptr && bvh8->preset != report.preset;
    const std::string method =
        is_chosen ? fmt::format("{} ({})", report.method, name_of(report.preset)) : report.method;
    return fmt::format("{}: {}, {}, {} of {} primitives sampled ({})\n", scene, method, tree,
                       report.sample_count, report.primitive_count, report.sample.sampler) +
           stages_text(report.stages) + tree_text(report) + memory_text(report) +
           estimate_text(report) + notes_text(report);
}

std::string process_text(std::uint64_t scene_bytes, std::uint64_t build_bytes,
                         std::uint64_t process_bytes) {
    return fmt::format("  process  {} bytes at most: scene and build {}, of these the scene {}\n",
                       process_bytes, scene_bytes + build_bytes, scene_bytes);
}

}  // namespace coppice::lab
