#include "coppice/base/error.h"

#include "report/chart_labels.h"
#include "report/chart_parts.h"
#include "report/charts.h"
#include "report/format.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <string>
#include <utility>
#include <vector>

namespace coppice::report {
namespace {

using nlohmann::json;

constexpr int plot_height = 320;

// What both cost-time charts are drawn from.
struct CostTime {
    TimeUnit unit;  // of the times
    json x;
    json y;
};

json cost_time_tooltip(const CostTime& parts, const json& values) {
    json lines{tip("protocol", "Protocol"), tip("label", "Sample")};
    const auto add = [&](const char* field, const std::string& title, const char* format) {
        const bool is_there =
            std::ranges::any_of(values, [&](const json& value) { return value.contains(field); });
        if (is_there) lines.push_back(tip(field, title, format));
    };
    add("cost", "SAH cost", ",.4~r");
    add("relative_cost", "Cost / full tree's", ",.4~r");
    add("time", "Build time (" + parts.unit.name + ")", ",.3~r");
    add("node_count", "Nodes", ",.0f");
    add("max_level", "Deepest level", ".3~r");
    return lines;
}

json cost_time_values(const Series& series, const CostTime& parts) {
    json values = json::array();
    for (const RatePoint& point : series.points) {
        const Range* cost = point.find("sah_cost");
        const Range* seconds = point.find("total_seconds");
        if (cost == nullptr || seconds == nullptr) continue;
        json value{{"protocol", protocol_style(point.protocol).label},
                   {"percent", point.percent},
                   {"label", format_percent(point.percent)},
                   {"recommended", point.is_recommended}};
        put_range(value, "cost", *cost);
        put_range(value, "time", *seconds, parts.unit.per_second);
        for (const char* key : {"relative_cost", "node_count", "max_level"}) {
            if (const Range* range = point.find(key)) value[key] = range->mean;
        }
        values.push_back(std::move(value));
    }
    return values;
}

// A side of a point where its label may stand, as Vega-Lite places text.
struct SidePlace {
    LabelSide side;
    const char* name;
    int dx;
    int dy;
    const char* align;
};

constexpr std::array<SidePlace, 6> side_places{{{LabelSide::above_right, "NE", 6, -10, "left"},
                                                {LabelSide::above, "N", 0, -12, "center"},
                                                {LabelSide::right, "E", 8, 0, "left"},
                                                {LabelSide::below_left, "SW", -6, 10, "right"},
                                                {LabelSide::below, "S", 0, 12, "center"},
                                                {LabelSide::left, "W", -8, 0, "right"}}};

// Adds the field `side` to the values whose label has room in a plot of common size.
void place_percent_labels(json& values, const CostTime& parts) {
    constexpr PlotPoint corner{500.0, plot_height};
    std::vector<LabelPoint> points;
    for (std::size_t i = 0; i < values.size(); ++i) {
        const json& value = values[i];
        const bool is_first = i == 0 || values[i - 1]["protocol"] != value["protocol"];
        const bool is_last =
            i + 1 == values.size() || values[i + 1]["protocol"] != value["protocol"];
        const PlotPoint at{corner.x * axis_position(parts.x, value["time"].get<double>()),
                           corner.y * (1.0 - axis_position(parts.y, value["cost"].get<double>()))};
        points.push_back(
            {.at = at,
             .line = points.empty() ? 0 : points.back().line + (is_first ? 1 : 0),
             .width = 6.5 * static_cast<double>(value["label"].get<std::string>().size() - 1),
             .priority = value["recommended"] == true ? 2.0
                         : is_first || is_last        ? 1.0
                                                      : 0.0});
    }
    const std::vector<LabelSide> sides = place_labels(points, corner);
    for (std::size_t i = 0; i < sides.size(); ++i) {
        const auto place = std::ranges::find(side_places, sides[i], &SidePlace::side);
        if (place != side_places.end()) values[i]["side"] = place->name;
    }
}

json label_layer(const SidePlace& place) {
    return {{"transform", {{{"filter", fmt::format("datum.side == '{}'", place.name)}}}},
            {"mark",
             {{"type", "text"},
              {"fontSize", 11},
              {"dx", place.dx},
              {"dy", place.dy},
              {"align", place.align}}},
            {"encoding", {{"text", {{"field", "label"}}}, {"color", {{"value", "currentColor"}}}}}};
}

json ring_layer(const json& tooltip) {
    return {{"transform", {{{"filter", "datum.recommended"}}}},
            {"mark",
             {{"type", "point"},
              {"shape", "circle"},
              {"size", 190},
              {"filled", false},
              {"strokeWidth", 1.5}}},
            {"encoding", {{"color", {{"value", "currentColor"}}}, {"tooltip", tooltip}}}};
}

json seed_rule_layer(const char* field, const char* channel) {
    const std::string name(field);
    return {{"mark", {{"type", "rule"}, {"opacity", 0.45}}},
            {"encoding",
             {{channel, {{"field", name + "_min"}}},
              {std::string(channel) + "2", {{"field", name + "_max"}}}}}};
}

json cost_time_chart(const Series& series, const CostTime& parts, const std::string& description) {
    const std::vector<std::string> protocols = series.protocols();
    json values = cost_time_values(series, parts);
    place_percent_labels(values, parts);
    const json tooltip = cost_time_tooltip(parts, values);

    json layers = json::array();
    if (has_seeds(series)) {
        layers.push_back(seed_rule_layer("cost", "y"));
        layers.push_back(seed_rule_layer("time", "x"));
    }
    layers.push_back({{"mark", line_mark()},
                      {"encoding", {{"order", {{"field", "percent"}, {"type", "quantitative"}}}}}});
    layers.push_back({{"mark", point_mark()},
                      {"encoding", {{"shape", protocol_shape(protocols)}, {"tooltip", tooltip}}}});
    layers.push_back(ring_layer(tooltip));
    for (const SidePlace& place : side_places) {
        layers.push_back(label_layer(place));
    }

    json chart = chart_frame(description, plot_height);
    chart["data"] = {{"values", values}};
    chart["encoding"] = {{"x", parts.x}, {"y", parts.y}, {"color", protocol_color(protocols)}};
    chart["layer"] = std::move(layers);
    return chart;
}

using MakeAxis = json(const std::string& field, const std::string& title,
                      const std::vector<double>& values);

CostTime cost_time_parts(const Series& series, MakeAxis& make_axis) {
    const TimeUnit unit = time_unit(series, "total_seconds");
    return {.unit = unit,
            .x = make_axis("time", "Build time, all stages (" + unit.name + ")",
                           collect_ends(series, "total_seconds", unit.per_second)),
            .y = make_axis("cost", "SAH cost", collect_ends(series, "sah_cost"))};
}

}  // namespace

json make_cost_time_chart(const Series& series) {
    return cost_time_chart(series, cost_time_parts(series, value_axis),
                           fmt::format("SAH cost against build time of the trees over the {} of {}",
                                       series.kind, series.scene));
}

json make_cost_time_chart(const json& results, std::string_view scene, std::string_view kind) {
    for (const Series& series : collect_series(results)) {
        if (series.scene == scene && series.kind == kind) return make_cost_time_chart(series);
    }
    throw Error(ErrorCode::invalid_argument,
                fmt::format("the results have no trees over the {} of {}", kind, scene));
}

json make_linear_cost_time_chart(const Series& series) {
    return cost_time_chart(
        series, cost_time_parts(series, linear_axis),
        fmt::format("SAH cost against build time, on linear axes, of the trees over the {} of {}",
                    series.kind, series.scene));
}

}  // namespace coppice::report
