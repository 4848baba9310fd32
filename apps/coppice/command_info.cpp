// coppice info: what a scene holds and what is odd about it.

#include "coppice/io/load_mesh.h"
#include "coppice/json/load_report.h"

#include "command.h"
#include "interrupts.h"
#include "options.h"
#include "scenes/mesh_summary.h"
#include "scenes/scene_names.h"
#include "text/json_text.h"
#include "text/progress_line.h"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <nlohmann/json.hpp>

#include <cmath>
#include <memory>

namespace coppice::app {

namespace {

struct InfoOptions {
    std::vector<std::string> scenes;
    bool as_json = false;
};

struct SceneInfo {
    std::string name;
    LoadReport load_report;
    lab::MeshSummary summary;
};

std::string oddity_text(const char* what, const LoadIssue& issue, const char* places) {
    if (issue.count == 0) return {};
    std::string text = fmt::format("    {:<34} {}", what, issue.count);
    if (!issue.first.empty()) {
        const bool is_all = issue.first.size() == issue.count;
        text += fmt::format("  ({}{} {})", is_all ? "" : "the first: ", places,
                            fmt::join(issue.first, ", "));
    }
    return text + '\n';
}

std::string count_text(const char* what, std::uint64_t count) {
    return count == 0 ? std::string() : fmt::format("    {:<34} {}\n", what, count);
}

std::string load_report_text(const LoadReport& report) {
    const std::string issues =
        oddity_text("polygons, cut into triangles", report.polygons, "faces") +
        oddity_text("faces of fewer than three corners", report.degenerate_faces, "faces") +
        oddity_text("triangles without area, kept", report.zero_area_triangles, "triangles") +
        oddity_text("repeated triangles, kept", report.duplicate_triangles, "triangles") +
        oddity_text("repeated vertices, kept", report.duplicate_vertices, "vertices") +
        oddity_text("vertices of no triangle, kept", report.unused_vertices, "vertices") +
        count_text("relative (negative) indices", report.negative_index_count) +
        count_text("lines that hold no triangles", report.ignored_line_count) +
        count_text("bytes behind the last row, unread", report.trailing_byte_count);
    return issues.empty() ? "  issues        none\n" : "  issues\n" + issues;
}

/// One line per decade, its bar as long as its share of the fullest decade.
std::string histogram_text(const lab::AreaDistribution& areas) {
    constexpr double longest_bar = 40.0;
    std::uint64_t fullest = 1;
    for (const lab::AreaDecade& decade : areas.decades) {
        fullest = std::max(fullest, decade.count);
    }
    std::string text;
    for (const lab::AreaDecade& decade : areas.decades) {
        const double share = static_cast<double>(decade.count) / static_cast<double>(fullest);
        const auto length = static_cast<std::size_t>(std::ceil(share * longest_bar));
        text += fmt::format("    from 1e{:<+4} {:>10}  {}\n", decade.exponent, decade.count,
                            std::string(length, '#'));
    }
    return text;
}

std::string areas_text(const lab::AreaDistribution& areas) {
    std::string text = fmt::format(
        "  triangle areas  total {:.6g}, mean {:.4g}, smallest {:.4g}, largest {:.4g}\n"
        "    percentiles  ",
        areas.total, areas.mean, areas.min, areas.max);
    for (std::size_t i = 0; i < areas.percentiles.size(); ++i) {
        text += fmt::format("{} {} %: {:.4g}", i == 0 ? "" : ",", areas.percents[i],
                            areas.percentiles[i]);
    }
    text += '\n';
    if (areas.zero_count > 0) text += fmt::format("    zero         {:>10}\n", areas.zero_count);
    return text + histogram_text(areas);
}

std::string bounds_text(const Aabb& bounds) {
    if (bounds.is_empty()) return "  bounds          none\n";
    const auto corner = [](Vec3f v) { return fmt::format("({}, {}, {})", v.x, v.y, v.z); };
    return fmt::format("  bounds          {} to {}\n  extent          {:.6g} x {:.6g} x {:.6g}\n",
                       corner(bounds.lower), corner(bounds.upper), bounds.extent(Axis::x),
                       bounds.extent(Axis::y), bounds.extent(Axis::z));
}

std::string info_text(const SceneInfo& info) {
    const LoadReport& load = info.load_report;
    const lab::MeshSummary& summary = info.summary;
    std::string text = fmt::format(
        "{}\n"
        "  file            {} ({}, {} bytes, loaded in {:.3f} s)\n"
        "  vertices        {}, at {} distinct positions\n"
        "  faces           {}\n"
        "  triangles       {}\n",
        info.name, load.file, load.format, load.file_bytes, load.load_seconds, summary.vertex_count,
        summary.distinct_vertex_count, load.face_count, summary.triangle_count);
    if (summary.edges.edges > 0) {
        text +=
            fmt::format("  edges           {}: {} of one triangle, {} of three or more\n",
                        summary.edges.edges, summary.edges.boundary, summary.edges.non_manifold);
    }
    text += bounds_text(summary.bounds);
    if (summary.triangle_count > 0) text += areas_text(summary.areas);
    return text + load_report_text(load);
}

nlohmann::ordered_json info_json(const SceneInfo& info) {
    nlohmann::ordered_json json{{"scene", info.name}, {"file", info.load_report.file}};
    json.update(nlohmann::ordered_json(nlohmann::json(info.summary)));
    json["load_report"] = nlohmann::json(info.load_report);
    return json;
}

SceneInfo inspect(const std::string& name, const std::string& file) {
    SceneInfo info{name, {}, {}};
    lab::ProgressLine progress(stderr);
    progress.show(name + ": loading");
    const TriangleMesh mesh = load_mesh(file, &info.load_report);
    progress.show(name + ": measuring");
    info.summary = lab::summarize(mesh.view());
    return info;
}

void show_info(const InfoOptions& options, Output& output) {
    const std::vector<std::filesystem::path> files(options.scenes.begin(), options.scenes.end());
    const std::vector<std::string> names = lab::scene_names(files);
    auto scenes = nlohmann::ordered_json::array();
    for (std::size_t i = 0; i < files.size(); ++i) {
        const SceneInfo info = inspect(names[i], options.scenes[i]);
        if (options.as_json) {
            scenes.push_back(info_json(info));
        } else {
            output.print((i == 0 ? "" : "\n") + info_text(info));
        }
    }
    if (options.as_json) {
        const nlohmann::ordered_json document{{"scenes", scenes}};
        output.print(lab::json_text(document));
    }
}

}  // namespace

Command add_info(CLI::App& program) {
    CLI::App* parser =
        program.add_subcommand("info", "Show what a scene holds and what is odd about it");
    parser->allow_extras();
    const auto options = std::make_shared<InfoOptions>();
    add_scenes(*parser, options->scenes);
    add_switch(*parser, "--json", "Print JSON instead of text",
               [options] { options->as_json = true; });
    parser->footer(
        "Examples:\n"
        "  coppice info scenes/dragon.obj\n"
        "  coppice info scenes/*.obj --json");
    return scene_command(parser, options, show_info);
}

}  // namespace coppice::app
