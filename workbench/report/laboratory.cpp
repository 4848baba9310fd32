#include "report/laboratory.h"

#include "report/chart_parts.h"
#include "report/charts_laboratory.h"
#include "report/figure.h"
#include "report/format.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <array>
#include <optional>
#include <string>
#include <utility>

namespace coppice::report {
namespace {

using nlohmann::json;

std::string decomposition_figures(const json& scene, const Series& series) {
    std::string html;
    for (const std::string& line : series.protocols()) {
        const json chart = make_decomposition_chart(scene, series, line);
        if (chart.is_null()) continue;
        html += figure(fmt::format("{}-parts-{}", series.key, make_slug(line)),
                       escape_html(capitalize(protocol_style(line).name)) + ".",
                       "Cost beyond the full tree of the same seed, by cause.", chart);
    }
    if (html.empty()) return {};
    return "<h4>What sampling costs, and why</h4><p>Early stop: <code>fixed</code> less "
           "<code>scaled</code>. Cells not empty: tests in cells that only the sample knew as "
           "empty. "
           "Duplicates: tests of references beyond a primitive’s first. SplitPlane error: what is "
           "left "
           "of the excess, but for duplicates, when all leaves are built on. Uneven leaves: the "
           "rest, leaves that the sample judged wrongly. Below 0: cheaper than the full tree.</p>"
           "<div class=\"grid thirds\">" +
           html + "</div>";
}

std::string pair_figure(const Series& series) {
    const json chart = make_pair_level_chart(series);
    if (chart.is_null()) return {};
    const TreePairPoints pair = find_tree_pair(series);
    return "<div class=\"grid\">" +
           figure(series.key + "-pair-levels", "Cost by depth, two trees side by side:",
                  fmt::format("the full one and the one built on {}{}, {}.",
                              format_percent(pair.sampled->percent),
                              pair.sampled->is_recommended ? ", which is recommended" : "",
                              escape_html(protocol_style(pair.full->protocol).name)),
                  chart) +
           "</div>";
}

// "kd" and "bvh8" for readers.
std::string form_name(std::string_view form) {
    return form == "kd" ? "k-d trees" : "8-wide trees (a test is of 8 triangles)";
}

std::string correlation_note(const json& rays, std::string_view form) {
    for (const json& found : array_at(rays, "correlations")) {
        if (text_at(found, "tree") != form || text_at(found, "rays") != "all") continue;
        const auto text = [&](const char* key) {
            const std::optional<double> number = number_at(found, key);
            return number ? fmt::format("{:.3f}", *number) : std::string("not defined");
        };
        return fmt::format(
            "Rank correlation (Spearman) over {} trees: {} with the time of a ray, {} with its "
            "counted steps.",
            format_count(number_at(found, "tree_count").value_or(0.0)), text("cost_with_time"),
            text("cost_with_steps"));
    }
    return {};
}

/// "45.7 ± 1.2"
std::string constant_text(const json& found, const std::string& name) {
    const std::string value = format_ratio(number_at(found, name + "_nanoseconds").value_or(0.0));
    const std::optional<double> error = number_at(found, name + "_error");
    return error ? fmt::format("{} ± {:.2g}", value, *error) : value;
}

std::string calibration_row(const json& found) {
    const auto number = [&](const char* key) { return number_at(found, key).value_or(0.0); };
    const std::optional<double> share = number_at(found, "r_squared");
    const std::string caution = text_at(found, "caution");
    return fmt::format(
        "<tr><th scope=\"row\">{}{}</th><td>{}</td><td>{}</td><td>{}</td><td>{}</td><td>{}</td>"
        "<td>{}</td><td>{}</td><td>{}</td></tr>",
        form_name(text_at(found, "tree")),
        caution.empty() ? "" : fmt::format("<small>{}</small>", escape_html(caution)),
        escape_html(text_at(found, "residuals")), constant_text(found, "traversal"),
        constant_text(found, "intersection"), share ? fmt::format("{:.4f}", *share) : "–",
        format_ratio(number("rms_nanoseconds")), format_share(number("relative_rms")),
        format_count(number("count")), format_count(number("tree_count")));
}

std::string calibration_table(const json& rays) {
    std::string rows;
    for (const json& found : array_at(rays, "calibrations")) {
        rows += calibration_row(found);
    }
    if (rows.empty()) return {};
    return "<div class=\"scroll\" tabindex=\"0\" role=\"region\" aria-label=\"Calibration\"><table>"
           "<caption>The constants of this machine: nanoseconds of a ray as t<sub>trav</sub> times "
           "nodes and t<sub>isect</sub> times tests, by non-negative least squares of the "
           "residuals, "
           "absolute ones or relative to each time; ± is the standard error. An observation is a "
           "tree with a kind of rays; wall clock on all threads.</caption><thead><tr><th "
           "scope=\"col\">trees</th>"
           "<th scope=\"col\">residuals</th><th scope=\"col\">t<sub>trav</sub> (ns)</th>"
           "<th scope=\"col\">t<sub>isect</sub> (ns)</th><th scope=\"col\">R²</th>"
           "<th scope=\"col\">RMS (ns)</th><th scope=\"col\">RMS of each</th>"
           "<th scope=\"col\">observations</th><th scope=\"col\">different trees</th></tr></thead>"
           "<tbody>" +
           rows + "</tbody></table></div>";
}

std::string ray_figures(const json& scene, const Series& series) {
    const json rays = scene.value("rays", json());
    if (series.kind != "triangles" || array_at(rays, "trees").empty()) return {};
    std::string figures;
    for (const char* form : {"kd", "bvh8"}) {
        const json chart = make_cost_ray_chart(scene, form);
        if (chart.is_null()) continue;
        figures += figure(fmt::format("{}-cost-ray-{}", series.key, form),
                          fmt::format("Does the cost tell the time? {}.", form_name(form)),
                          correlation_note(rays, form), chart);
    }
    figures += figure(series.key + "-image-time", "Time to an image against its number of rays.",
                      "Thick: the fastest tree, changing at the break-even points; thin: all "
                      "others.",
                      make_image_time_chart(scene));
    return "<h4>What rays measured</h4>" + calibration_table(rays) + "<div class=\"grid\">" +
           figures + "</div>";
}

}  // namespace

std::string make_laboratory(const json& scene, const Series& series) {
    return decomposition_figures(scene, series) + pair_figure(series) + ray_figures(scene, series);
}

}  // namespace coppice::report
