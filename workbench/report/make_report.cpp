#include "report/make_report.h"

#include "report/assets.h"
#include "report/chart_parts.h"
#include "report/charts.h"
#include "report/exhibit_figures.h"
#include "report/figure.h"
#include "report/format.h"
#include "report/laboratory.h"
#include "report/series.h"
#include "report/summary.h"
#include "report/tables.h"
#include "report/thesis_data.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <iterator>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace coppice::report {
namespace {

using nlohmann::json;

// The page's skeleton with each {{name}} replaced; what is put in is not looked into again.
std::string fill(std::string_view skeleton, const std::map<std::string_view, std::string>& parts) {
    std::string page;
    while (!skeleton.empty()) {
        const std::size_t open = skeleton.find("{{");
        page += skeleton.substr(0, open);
        if (open == std::string_view::npos) break;
        const std::size_t close = skeleton.find("}}", open);
        page += parts.at(skeleton.substr(open + 2, close - open - 2));
        skeleton.remove_prefix(close + 2);
    }
    return page;
}

std::string scene_facts(const json& scene) {
    std::vector<std::string> facts;
    for (const auto& [key, noun] :
         {std::pair{"triangle_count", "triangles"}, std::pair{"vertex_count", "vertices"},
          std::pair{"distinct_vertex_count", "of them distinct"}}) {
        if (const auto count = number_at(scene, key)) {
            facts.push_back(format_count(*count) + " " + noun);
        }
    }
    if (const std::string file = text_at(scene, "file"); !file.empty()) {
        facts.push_back("<code>" + escape_html(file) + "</code>");
    }
    std::string text;
    for (const std::string& fact : facts) {
        text += (text.empty() ? "" : " · ") + fact;
    }
    return text;
}

std::string seed_note(const Series& series) {
    std::size_t most = 0;
    for (const RatePoint& point : series.points) {
        most = std::max(most, point.seed_count);
    }
    if (most <= 1) return {};
    return fmt::format("Mean of {} seeds, with {}.", most,
                       has_intervals(series, "sah_cost")
                           ? "95 % t intervals (of relative costs paired by seed)"
                           : "the least and the greatest");
}

std::string cost_time_figure(const Series& series) {
    return figure(
        series.key + "-cost-time",
        fmt::format("Cost against build time, {}.", escape_html(series.kind)),
        "Down and left is better; rings mark what the rule recommends. " + seed_note(series),
        make_cost_time_chart(series));
}

// The kind that rays are traced against is the main one, where there is one.
const Series& main_series(const std::vector<Series>& series) {
    const auto triangles = std::ranges::find(series, "triangles", &Series::kind);
    return triangles != series.end() ? *triangles : series.front();
}

// The picture, the answer and the main chart; what follows is for the second look.
std::string answer_section(const json& scene, const std::vector<Series>& series,
                           const SceneExhibits& exhibits, const std::string& anchor) {
    const std::string name = text_at(scene, "scene");
    std::string html = fmt::format(
        "<section class=\"scene-answer\" aria-labelledby=\"answer-{0}\"><h2 id=\"answer-{0}\">{1}"
        " <small>{2}</small></h2>\n{3}",
        anchor, escape_html(name), scene_facts(scene), make_answer(scene, series));
    if (series.empty()) return html + "</section>\n";
    html += "<div class=\"grid\">" + make_picture(exhibits, name);
    html += cost_time_figure(main_series(series)) + "</div>";
    const bool has_verdict = std::ranges::any_of(series, &Series::has_relative_cost);
    if (has_verdict) html += make_recommendation_table(scene, series);
    return html + "</section>\n";
}

std::string thesis_figures(const Series& series) {
    const bool is_relative = series.has_relative_cost();
    const Measure cost = is_relative ? Measure{"relative_cost", "Cost / full tree's cost"}
                                     : Measure{"sah_cost", "SAH cost"};
    const Measure time{"total_seconds", "Build time, all stages", true};
    const Measure nodes{"node_count", "Nodes"};
    const Measure levels{"max_level", "Deepest level"};
    const Measure leaves{"mean_leaf_size", "References per leaf"};
    std::string html = "<div class=\"grid\">";
    html += figure(series.key + "-cost", "Cost of each tree", "(thesis: figure 3).",
                   make_rate_chart(series, cost));
    html += figure(series.key + "-time", "Build time of each tree", "(thesis: figure 4).",
                   make_rate_chart(series, time));
    html += figure(series.key + "-nodes", "Nodes of each tree", "(thesis: figures 5 to 8).",
                   make_rate_chart(series, nodes));
    html += figure(series.key + "-levels", "Levels of each tree", "(thesis: figures 5 to 8).",
                   make_rate_chart(series, levels));
    html += figure(series.key + "-leaf-size", "Mean leaf of each tree", "(not in the thesis).",
                   make_rate_chart(series, leaves));
    html += figure(series.key + "-cost-time-linear", "Cost against build time",
                   "on the thesis’s linear axes (figures 9 to 12), on which the knee is judged.",
                   make_linear_cost_time_chart(series));
    return html + "</div>";
}

std::string comparison(const Series& series) {
    const ThesisTables& thesis = thesis_tables();
    return make_thesis_comparison(series, thesis) + "<div class=\"grid\">" +
           figure(series.key + "-thesis-cost", "Cost, here and in the thesis,",
                  "relative to each scene’s own 100&nbsp;% tree.",
                  make_thesis_chart(series, thesis, ThesisMeasure::cost)) +
           figure(
               series.key + "-thesis-time", "Build time, here and in the thesis,",
               "relative to each scene’s own 100&nbsp;% tree. The thesis gives whole seconds; its"
               " zeros are left out.",
               make_thesis_chart(series, thesis, ThesisMeasure::build_time)) +
           "</div>" + make_thesis_table(series, thesis);
}

std::string stage_figures(const Series& series) {
    std::string html = "<div class=\"grid thirds\">";
    for (const std::string& protocol : series.protocols()) {
        html += figure(fmt::format("{}-stages-{}", series.key, make_slug(protocol)),
                       escape_html(capitalize(protocol_style(protocol).name)) + ".",
                       "Time of the five stages of a build.", make_stage_chart(series, protocol));
    }
    return html + "</div>";
}

bool has_details(const Series& series) {
    return std::ranges::any_of(series.points, [](const RatePoint& point) {
        return point.find("expected_inner_visits") != nullptr;
    });
}

std::string ray_figures(const Series& series) {
    struct Count {
        const char* key;
        const char* id;
        const char* title;
    };

    constexpr std::array counts{Count{"expected_inner_visits", "inner-visits", "Inner nodes"},
                                Count{"expected_leaf_visits", "leaf-visits", "Leaves"},
                                Count{"expected_primitive_tests", "tests", "Primitive tests"}};
    std::string html = "<div class=\"grid thirds\">";
    for (const Count& count : counts) {
        html += figure(series.key + "-" + count.id, std::string(count.title), "expected per ray.",
                       make_rate_chart(series, {count.key, std::string(count.title) + " per ray"}));
    }
    html += "</div><div class=\"grid\">";
    const std::string note =
        "Choose the sample below the chart. Dashed: the tree built on 100&nbsp;%, " +
        escape_html(protocol_style(series.protocols().front()).name) + ".";
    html += figure(series.key + "-cost-share", "Where the cost lies.", note,
                   make_level_chart(series, {.key = "cost_share_by_depth",
                                             .title = "Share of the cost",
                                             .is_share = true}));
    html += figure(series.key + "-leaf-levels", "Where the leaves lie.", note,
                   make_level_chart(series, {"depth_histogram", "Leaves"}));
    return html + "</div>";
}

// The thesis's primitives are points; where there are none, the first kind stands for them.
const Series& comparable_series(const std::vector<Series>& series) {
    const auto points = std::ranges::find(series, "points", &Series::kind);
    return points != series.end() ? *points : series.front();
}

// What a kind's section has beside what all have.
struct KindParts {
    bool has_main_chart = false;  // or else it is on the first screen
    bool has_thesis = false;
};

std::string kind_section(const json& scene, const Series& series, const KindParts& parts) {
    const std::string kind = escape_html(series.kind);
    std::string html = fmt::format("<section><h3 id=\"{}\">Trees over {}</h3>", series.key, kind);
    html += make_findings(series);
    if (parts.has_main_chart) {
        html += "<div class=\"grid\">" + cost_time_figure(series) + "</div>";
    }
    html += "<h4>The thesis’s figures again</h4>" + thesis_figures(series);
    if (parts.has_thesis) html += "<h4>Beside the thesis’s own numbers</h4>" + comparison(series);
    html += "<h4>Where the time goes</h4>" + stage_figures(series);
    if (has_details(series)) html += "<h4>What a ray meets</h4>" + ray_figures(series);
    html += make_laboratory(scene, series);
    return html + "<h4>All trees</h4>" + make_rows_table(scene, series) + "</section>\n";
}

std::string exhibit_section(const json& scene, const SceneExhibits& exhibits,
                            const std::string& anchor) {
    std::string html = make_heat_maps(exhibits, text_at(scene, "scene")) +
                       make_inspector(exhibits, "scene-" + anchor);
    if (!exhibits.missing.empty()) html += "<p>" + escape_html(exhibits.missing) + "</p>";
    if (html.empty()) return {};
    return fmt::format("<section><h3 id=\"trees-{}\">The trees, seen</h3>{}</section>\n", anchor,
                       html);
}

std::string scene_section(const json& scene, const std::vector<Series>& series,
                          const SceneExhibits& exhibits, const std::string& anchor) {
    std::string html = fmt::format(
        "<section class=\"scene\" aria-labelledby=\"scene-{0}\">"
        "<h2 id=\"scene-{0}\">{1} in detail</h2>\n",
        anchor, escape_html(text_at(scene, "scene")));
    html += exhibit_section(scene, exhibits, anchor);
    for (const Series& kind : series) {
        html += kind_section(scene, kind,
                             {.has_main_chart = &kind != &main_series(series),
                              .has_thesis = &kind == &comparable_series(series)});
    }
    json loaded = json::object();
    if (scene.contains("load_report")) loaded = scene["load_report"];
    if (scene.contains("bounds") && loaded.is_object()) loaded["bounds"] = scene["bounds"];
    return html + "<h3>The scene as it was loaded</h3>" + make_fields_table(loaded, "Load report") +
           "</section>\n";
}

std::string licenses(const Assets& assets) {
    std::string text;
    for (const auto& [name, license] :
         {std::pair{"Vega", assets.vega_license}, std::pair{"Vega-Lite", assets.vega_lite_license},
          std::pair{"Vega-Embed", assets.vega_embed_license},
          std::pair{"D3 (inside Vega)", assets.d3_license},
          std::pair{"three.js", assets.three_license}}) {
        text += fmt::format("{}\n\n{}\n\n", name, license);
    }
    return escape_html(text);
}

// What the results say of a text field, for the page.
std::string stated(const json& object, std::string_view key) {
    const std::string text = text_at(object, key);
    return text.empty() ? "not recorded" : escape_html(text);
}

std::string constant(const json& results, std::string_view key) {
    const json options = results.value("options", json::object());
    const std::optional<double> number = number_at(options, key);
    return number ? fmt::format("{:.6g}", *number) : "not recorded";
}

json setup_fields(const json& results) {
    json fields = json::object();
    for (const char* key :
         {"coppice", "git_revision", "created", "compiler", "build_type", "flags"}) {
        if (results.contains(key)) fields[key] = results[key];
    }
    std::string command;
    for (const json& word : array_at(results, "command")) {
        if (word.is_string()) {
            command += (command.empty() ? "" : " ") + word.get<std::string>();
        }
    }
    if (!command.empty()) {
        fields["command"] = command;
    }
    return fields;
}

// What the page tells of the experiment as a whole.
std::map<std::string_view, std::string> results_parts(const json& results) {
    return {{"created", stated(results, "created")},
            {"version", stated(results, "coppice")},
            {"revision", stated(results, "git_revision")},
            {"compiler", stated(results, "compiler")},
            {"cpu", stated(results.value("machine", json::object()), "cpu")},
            {"program", make_fields_table(setup_fields(results), "Program")},
            {"machine", make_fields_table(results.value("machine", json()), "Machine")},
            {"options", make_fields_table(results.value("options", json()), "Options")},
            {"traversal_cost", constant(results, "traversal_cost")},
            {"intersection_cost", constant(results, "intersection_cost")},
            {"empty_bonus", constant(results, "empty_bonus")},
            {"max_leaf", constant(results, "max_leaf")},
            {"max_depth", constant(results, "max_depth")},
            {"bad_refines", constant(results, "bad_refines")},
            {"results", script_json(results)}};
}

bool has_inspector(const SceneExhibits& exhibits) {
    return exhibits.inspector.has_value();
}

// Style, scripts and licences; three.js is half of them and comes only where it is used.
std::map<std::string_view, std::string> library_parts(bool with_inspector) {
    const Assets& assets = embedded_assets();
    return {{"style", std::string(assets.page_css)},
            {"licenses", licenses(assets)},
            {"vega", script_text(assets.vega)},
            {"vega_lite", script_text(assets.vega_lite)},
            {"vega_embed", script_text(assets.vega_embed)},
            {"script", script_text(assets.page_js)},
            {"inspector_script", with_inspector ? script_text(assets.inspector_js) : ""}};
}

}  // namespace

std::string make_report(const json& results, std::span<const SceneExhibits> exhibits) {
    const std::vector<Series> all = collect_series(results);
    const json& scenes = results["scenes"];
    std::string answers;
    std::string details;
    std::string links;
    std::vector<std::string> names;
    for (std::size_t i = 0; i < scenes.size(); ++i) {
        std::vector<Series> series;
        std::ranges::copy_if(all, std::back_inserter(series),
                             [&](const Series& one) { return one.scene_index == i; });
        const SceneExhibits none;
        const SceneExhibits& shown = i < exhibits.size() ? exhibits[i] : none;
        const std::string anchor = std::to_string(i + 1);
        answers += answer_section(scenes[i], series, shown, anchor);
        details += scene_section(scenes[i], series, shown, anchor);
        names.push_back(escape_html(text_at(scenes[i], "scene")));
        links += fmt::format("<li><a href=\"#scene-{}\">{}</a></li>", anchor, names.back());
    }
    if (scenes.empty()) answers = "<p class=\"answer\">The results hold no scene.</p>";

    std::map<std::string_view, std::string> parts = results_parts(results);
    parts.merge(library_parts(std::ranges::any_of(exhibits, has_inspector)));
    parts["title"] = names.empty() ? "no scenes" : join_words(names);
    parts["links"] = links;
    parts["answers"] = answers;
    parts["details"] = details;
    return fill(embedded_assets().page_html, parts);
}

}  // namespace coppice::report
