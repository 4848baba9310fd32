#include "report/exhibit_figures.h"

#include "report/base64.h"
#include "report/chart_parts.h"
#include "report/format.h"
#include "report/inspector_data.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>

namespace coppice::report {
namespace {

// Levels of at most so many cells are clear enough to begin with.
constexpr std::uint64_t clear_cell_count = 300;

std::string image(const Picture& picture, const std::string& alternative) {
    return fmt::format(
        "<img src=\"data:image/png;base64,{}\" width=\"{}\" height=\"{}\" alt=\"{}\">",
        base64(picture.png), picture.width, picture.height, escape_html(alternative));
}

/// "the tree of all triangles", "the tree built on 1 % of the triangles".
std::string tree_text(const SceneExhibits& exhibits, const TreeName& tree) {
    return escape_html(tree.percent == 100.0
                           ? fmt::format("the tree of all {}", exhibits.kind)
                           : fmt::format("the tree built on {} of the {}",
                                         format_percent(tree.percent), exhibits.kind));
}

std::string protocol_text(const SceneExhibits& exhibits) {
    return escape_html(protocol_style(exhibits.full.protocol).name);
}

/// Which two trees are shown, and why these.
std::string choice_text(const SceneExhibits& exhibits) {
    if (!exhibits.other) {
        return fmt::format("Shown is {}. Protocol: {}.", tree_text(exhibits, exhibits.full),
                           protocol_text(exhibits));
    }
    return fmt::format("Shown are {} and {}{}. Protocol: {}.", tree_text(exhibits, exhibits.full),
                       tree_text(exhibits, *exhibits.other),
                       exhibits.is_recommended
                           ? ", which is recommended"
                           : " (no smaller sample than all is recommended; this is the next one)",
                       protocol_text(exhibits));
}

std::string legend(const ColorScale& scale, const std::string& low, const std::string& high) {
    std::string stops;
    for (const std::string& color : scale.colors) {
        if (!stops.empty()) stops += ',';
        stops += escape_html(color);
    }
    return fmt::format(
        "<p class=\"legend\"><span>{}</span><span class=\"bar\" style=\"background-image:"
        "linear-gradient(to right,{})\"></span><span>{}</span></p>",
        low, stops, high);
}

std::string heat_map(const Picture& picture, const std::string& alternative,
                     const std::string& title, const std::string& note) {
    return fmt::format("<figure class=\"picture\">{}<figcaption><b>{}</b> {}</figcaption></figure>",
                       image(picture, alternative), title, note);
}

std::string checkbox(std::string_view name, std::string_view label, bool is_checked) {
    return fmt::format("<label><input type=\"checkbox\" name=\"{}\"{}> {}</label>", name,
                       is_checked ? " checked" : "", label);
}

std::string controls(const Inspector& inspector, std::string_view key) {
    const std::size_t levels = std::max(inspector.full.size(), inspector.other.size());
    std::size_t first = 0;
    while (first + 1 < inspector.full.size() &&
           inspector.full[first + 1].cell_count <= clear_cell_count) {
        ++first;
    }
    return fmt::format(
        "<div class=\"controls\"><label for=\"{0}-level\">Level</label>"
        "<input type=\"range\" id=\"{0}-level\" name=\"level\" min=\"0\" max=\"{1}\" value=\"{2}\">"
        "<output for=\"{0}-level\">{2}</output>"
        "<label>Colour <select name=\"colour\"><option value=\"shares\">cost</option>"
        "<option value=\"counts\">primitives</option></select></label>{3}{4}"
        "<button type=\"button\" name=\"reset\">Reset the view</button></div>",
        key, levels - 1, first, checkbox("scene", "scene", true),
        checkbox("empty", "empty cells", false));
}

std::string tree_view(const SceneExhibits& exhibits, const TreeName& tree) {
    const std::string title = capitalize(tree_text(exhibits, tree));
    return fmt::format(
        "<figure><canvas tabindex=\"0\" role=\"application\" aria-label=\"Cells of {0}. Arrow keys "
        "turn the "
        "view, plus and minus change its distance.\"></canvas>"
        "<figcaption><b>{1}.</b> <span class=\"readout\" aria-live=\"polite\"></span></figcaption>"
        "</figure>",
        tree_text(exhibits, tree), title);
}

}  // namespace

std::string make_picture(const SceneExhibits& exhibits, std::string_view scene) {
    if (exhibits.picture.png.empty()) return {};
    return fmt::format(
        "<figure class=\"picture\">{}<figcaption><b>The scene</b> as <code>coppice render {}"
        "</code> shows it.</figcaption></figure>",
        image(exhibits.picture, fmt::format("{}, rendered", scene)),
        escape_html(exhibits.picture_camera));
}

std::string make_heat_maps(const SceneExhibits& exhibits, std::string_view scene) {
    if (!exhibits.heat_maps) return {};
    const HeatMaps& maps = *exhibits.heat_maps;
    const auto alternative = [&](std::string_view what) {
        return fmt::format("{} of each pixel of {}", what, scene);
    };
    std::string text = fmt::format(
        "<h4>What each pixel’s ray costs</h4><p>Nodes visited and primitives tested by the camera’s"
        " rays. {} A ray takes {} steps on average in the full tree",
        choice_text(exhibits), format_ratio(maps.full_mean));
    std::string figures = heat_map(maps.full, alternative("Steps in the full tree"), "Full tree",
                                   fmt::format("{} steps a ray.", format_ratio(maps.full_mean)));
    std::string scales =
        legend(maps.steps, "0", fmt::format("{} steps or more", format_count(maps.steps.high)));
    if (exhibits.other) {
        text += fmt::format(" and {} in the other", format_ratio(maps.other_mean));
        if (maps.full_mean > 0.0) {
            text +=
                fmt::format(", {} times as many", format_ratio(maps.other_mean / maps.full_mean));
        }
        figures += heat_map(maps.other, alternative("Steps in the other tree"),
                            fmt::format("Built on {}", format_percent(exhibits.other->percent)),
                            fmt::format("{} steps a ray.", format_ratio(maps.other_mean)));
        figures += heat_map(maps.difference, alternative("Difference of the steps"), "Difference",
                            fmt::format("{:+.3g} steps a ray.", maps.other_mean - maps.full_mean));
        const std::string most = format_count(maps.change.high);
        scales += legend(maps.change, fmt::format("{} fewer", most), fmt::format("{} more", most));
    }
    return text + ".</p><div class=\"grid thirds heat\">" + figures +
           "</div><div class=\"scales\">" + scales + "</div>";
}

std::string make_inspector(const SceneExhibits& exhibits, std::string_view key) {
    if (!exhibits.inspector || exhibits.inspector->full.empty()) return {};
    const Inspector& inspector = *exhibits.inspector;
    std::string views = tree_view(exhibits, exhibits.full);
    if (exhibits.other) views += tree_view(exhibits, *exhibits.other);
    return fmt::format(
        "<h4 id=\"{0}-inspector\">The trees, level by level</h4><p>{1} A box is a node of the level"
        " chosen. <span class=\"hint\">Drag to turn, scroll to come closer once a view is clicked;"
        " both views move together. With the keyboard: arrow keys, + and −, Home.</span></p>"
        "<div class=\"inspector\" data-inspector=\"{0}-inspector-data\" role=\"group\""
        " aria-labelledby=\"{0}-inspector\">{2}<p class=\"message\" role=\"status\" hidden></p>"
        "<div class=\"grid views\">{3}</div><p class=\"legend\" hidden><span></span>"
        "<span class=\"bar\"></span><span></span></p></div>"
        "<script type=\"application/json\" id=\"{0}-inspector-data\">{4}</script>",
        key, choice_text(exhibits), controls(inspector, key), views,
        script_json(inspector_data(inspector)));
}

}  // namespace coppice::report
