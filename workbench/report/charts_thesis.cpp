#include "report/chart_parts.h"
#include "report/charts.h"
#include "report/format.h"

#include <array>
#include <optional>
#include <string>
#include <vector>

namespace coppice::report {
namespace {

using nlohmann::json;

// One line of the chart, ours or a scene of the thesis.
struct Source {
    std::string label;
    std::string color;
    json dash;
};

struct Lines {
    std::vector<Source> sources;
    json values = json::array();
    std::vector<double> ratios;
    std::vector<double> percents;

    // Nothing is drawn of a ratio of 0: the thesis's times are whole seconds, 0 says too little.
    void add(const std::string& source, double percent, double ratio) {
        if (!(ratio > 0.0)) return;
        values.push_back({{"source", source},
                          {"percent", percent},
                          {"label", format_percent(percent)},
                          {"value", rounded(ratio)}});
        ratios.push_back(ratio);
        percents.push_back(percent);
    }
};

std::optional<double> ratio_of(const Series& series, const RatePoint& point, bool is_cost) {
    if (!is_cost) return series.relative_time(point);
    const Range* cost = point.find("relative_cost");
    return cost != nullptr ? std::optional(cost->mean) : std::nullopt;
}

void add_ours(Lines& lines, const Series& series, bool is_cost) {
    for (const RatePoint& point : series.points) {
        const auto ratio = ratio_of(series, point, is_cost);
        if (!ratio) continue;
        const ProtocolStyle style = protocol_style(point.protocol);
        if (lines.sources.empty() || lines.sources.back().label != style.label) {
            lines.sources.push_back({style.label, style.color, json::array({1, 0})});
        }
        lines.add(style.label, point.percent, *ratio);
    }
}

void add_thesis(Lines& lines, const ThesisTables& thesis, double ThesisRow::*measure) {
    const std::array dashes{json::array({2, 2}), json::array({6, 3}), json::array({12, 3}),
                            json::array({12, 3, 2, 3})};
    std::size_t number = 0;
    for (const std::string& scene : thesis.scenes()) {
        const std::string label = "thesis: " + thesis_scene_title(scene);
        lines.sources.push_back({label, "#cc79a7", dashes[number++ % dashes.size()]});
        const ThesisRow* full = thesis.find(scene, 100.0);
        for (const ThesisRow& row : thesis.rows) {
            if (row.scene != scene || full == nullptr) continue;
            lines.add(label, row.percent, row.*measure / full->*measure);
        }
    }
}

json source_scale(const Lines& lines, const char* range_of) {
    json domain = json::array();
    json range = json::array();
    for (const Source& source : lines.sources) {
        domain.push_back(source.label);
        range.push_back(std::string_view(range_of) == "color" ? json(source.color) : source.dash);
    }
    return {{"field", "source"},
            {"type", "nominal"},
            {"title", nullptr},
            {"scale", {{"domain", domain}, {"range", range}}},
            {"legend", {{"columns", 2}, {"symbolType", "stroke"}, {"symbolSize", 300}}}};
}

}  // namespace

json make_thesis_chart(const Series& series, const ThesisTables& thesis, ThesisMeasure measure) {
    const bool is_cost = measure == ThesisMeasure::cost;
    Lines lines;
    add_ours(lines, series, is_cost);
    add_thesis(lines, thesis, is_cost ? &ThesisRow::sah_cost : &ThesisRow::build_seconds);
    const std::string title =
        is_cost ? "Cost / full tree's cost" : "Build time / full tree's build time";

    json chart = chart_frame(
        title + ", here and in the thesis, " + series.kind + " of " + series.scene, 300);
    chart["data"] = {{"values", lines.values}};
    std::ranges::sort(lines.percents, std::greater<>());
    chart["encoding"] = {{"x", percent_axis(lines.percents)},
                         {"y", value_axis("value", title, lines.ratios)},
                         {"color", source_scale(lines, "color")},
                         {"strokeDash", source_scale(lines, "dash")}};
    chart["layer"] = {
        {{"mark", line_mark()}},
        {{"mark", point_mark(24)},
         {"encoding",
          {{"strokeDash", {{"value", {1, 0}}}},
           {"tooltip",
            {tip("source", "Tree"), tip("label", "Sample"), tip("value", title, ",.3~r")}}}}}};
    return chart;
}

}  // namespace coppice::report
