#include "report/chart_parts.h"
#include "report/charts.h"
#include "report/format.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <utility>

namespace coppice::report {
namespace {

using nlohmann::json;

constexpr std::array<StackPart, 5> stages{{{"sample_seconds", "draw sample", "#56b4e9"},
                                           {"build_seconds", "build", "#0072b2"},
                                           {"empty_seconds", "empty", "#cc79a7"},
                                           {"refill_seconds", "refill", "#e69f00"},
                                           {"refine_seconds", "refine", "#009e73"}}};

json level_values(const Series& series, const std::string& key) {
    json values = json::array();
    const std::vector<std::string> protocols = series.protocols();
    for (const RatePoint& point : series.points) {
        const auto at = point.levels.find(key);
        if (at == point.levels.end()) continue;
        const bool is_full = point.percent == 100.0 && point.protocol == protocols.front();
        for (std::size_t level = 0; level < at->second.size(); ++level) {
            values.push_back({{"protocol", protocol_style(point.protocol).label},
                              {"percent", point.percent},
                              {"level", level},
                              {"value", rounded(at->second[level])},
                              {"full", is_full}});
        }
    }
    return values;
}

// The reader's choice of a percentage, at first the smallest.
json percent_choice(const Series& series, const std::string& key) {
    json options = json::array();
    json labels = json::array();
    for (const double percent : series.percents()) {
        const bool has_levels = std::ranges::any_of(series.points, [&](const RatePoint& point) {
            return point.percent == percent && point.levels.contains(key);
        });
        if (!has_levels) continue;
        options.push_back(percent);
        labels.push_back(format_percent(percent));
    }
    const json value = options.empty() ? json(100.0) : options.back();
    return {{"name", "shown"},
            {"value", value},
            {"bind",
             {{"input", "select"}, {"name", "Sample "}, {"options", options}, {"labels", labels}}}};
}

}  // namespace

json make_rate_chart(const Series& series, const Measure& measure) {
    const TimeUnit unit =
        measure.is_seconds ? time_unit(series, measure.key) : TimeUnit{.name = {}};
    const std::string title =
        measure.is_seconds ? fmt::format("{} ({})", measure.title, unit.name) : measure.title;
    json values = json::array();
    for (const RatePoint& point : series.points) {
        if (const Range* range = point.find(measure.key)) {
            json value{{"protocol", protocol_style(point.protocol).label},
                       {"percent", point.percent},
                       {"label", format_percent(point.percent)}};
            put_range(value, "value", *range, unit.per_second);
            values.push_back(std::move(value));
        }
    }

    json tooltip{tip("protocol", "Protocol"), tip("label", "Sample"), tip("value", title, ",.4~r")};
    json layers = json::array();
    if (has_seeds(series)) {
        const bool is_interval = has_intervals(series, measure.key);
        tooltip.push_back(tip("value_min", is_interval ? "95 % from" : "least", ",.4~r"));
        tooltip.push_back(tip("value_max", is_interval ? "95 % to" : "greatest", ",.4~r"));
        layers.push_back(
            {{"mark", {{"type", "area"}, {"opacity", 0.22}}},
             {"encoding", {{"y", {{"field", "value_min"}}}, {"y2", {{"field", "value_max"}}}}}});
    }
    const std::vector<std::string> protocols = series.protocols();
    layers.push_back({{"mark", line_mark()}});
    layers.push_back({{"mark", point_mark()},
                      {"encoding", {{"shape", protocol_shape(protocols)}, {"tooltip", tooltip}}}});

    json chart = chart_frame(
        fmt::format("{} by sample percentage, {} of {}", measure.title, series.kind, series.scene),
        220);
    chart["data"] = {{"values", values}};
    chart["encoding"] = {
        {"x", percent_axis(series.percents())},
        {"y", value_axis("value", title, collect_ends(series, measure.key, unit.per_second))},
        {"color", protocol_color(protocols)}};
    chart["layer"] = std::move(layers);
    return chart;
}

json make_stage_chart(const Series& series, std::string_view protocol) {
    const TimeUnit unit = time_unit(series, "total_seconds");
    json values = json::array();
    for (const RatePoint& point : series.points) {
        if (point.protocol != protocol) continue;
        for (std::size_t i = 0; i < stages.size(); ++i) {
            const Range* seconds = point.find(stages[i].key);
            values.push_back(
                {{"label", fmt::format("{:.6g}", point.percent)},
                 {"stage", stages[i].label},
                 {"stage_index", i},
                 {"time", seconds != nullptr ? seconds->mean * unit.per_second : 0.0}});
        }
    }
    json names = json::array();
    json colors = json::array();
    for (const StackPart& stage : stages) {
        names.push_back(stage.label);
        colors.push_back(stage.color);
    }
    const std::string time_title = "Build time (" + unit.name + ")";
    json chart = chart_frame(fmt::format("Seconds of each stage, {}, {} of {}",
                                         protocol_style(protocol).label, series.kind, series.scene),
                             220);
    chart["data"] = {{"values", values}};
    chart["mark"] = {{"type", "bar"}};
    chart["encoding"] = {{"x",
                          {{"field", "label"},
                           {"type", "ordinal"},
                           {"sort", nullptr},
                           {"title", "Sample (% of the primitives)"},
                           {"axis", {{"labelAngle", 0}}}}},
                         {"y", linear_axis("time", time_title,
                                           collect_ends(series, "total_seconds", unit.per_second))},
                         {"order", {{"field", "stage_index"}, {"type", "quantitative"}}},
                         {"color",
                          {{"field", "stage"},
                           {"type", "nominal"},
                           {"title", nullptr},
                           {"scale", {{"domain", names}, {"range", colors}}},
                           {"legend", {{"columns", 3}}}}},
                         {"tooltip",
                          {tip("stage", "StackPart"), tip("label", "Sample (%)"),
                           tip("time", time_title, ",.3~r")}}};
    chart["encoding"]["y"]["scale"]["domain"][0] = 0.0;  // bars start at nothing
    return chart;
}

json make_level_chart(const Series& series, const Measure& measure) {
    const std::vector<std::string> protocols = series.protocols();
    const json y{{"field", "value"},
                 {"type", "quantitative"},
                 {"title", measure.title},
                 {"axis", {{"format", measure.is_share ? "~%" : "~s"}, {"tickCount", 6}}}};
    const json x{{"field", "level"}, {"type", "quantitative"}, {"title", "Level of the tree"}};
    const json tooltip{tip("protocol", "Protocol"), tip("percent", "Sample (%)"),
                       tip("level", "Level"),
                       tip("value", measure.title, measure.is_share ? ".2~%" : ",.3~r")};
    json chart = chart_frame(
        fmt::format("{} by level, {} of {}", measure.title, series.kind, series.scene), 220);
    chart["data"] = {{"values", level_values(series, measure.key)}};
    chart["params"] = {percent_choice(series, measure.key)};
    chart["encoding"] = {{"x", x}, {"y", y}};
    json layers = json::array();
    const bool has_full = std::ranges::any_of(
        chart["data"]["values"], [](const json& value) { return value["full"] == true; });
    if (has_full) {
        layers.push_back({{"transform", {{{"filter", "datum.full"}}}},
                          {"mark",
                           {{"type", "line"},
                            {"color", "currentColor"},
                            {"strokeDash", {4, 3}},
                            {"strokeWidth", 1.5}}}});
    }
    const json shown{{{"filter", "datum.percent == shown"}}};
    layers.push_back({{"transform", shown},
                      {"mark", line_mark()},
                      {"encoding", {{"color", protocol_color(protocols)}}}});
    layers.push_back({{"transform", shown},
                      {"mark", point_mark(28)},
                      {"encoding",
                       {{"color", protocol_color(protocols)},
                        {"shape", protocol_shape(protocols)},
                        {"tooltip", tooltip}}}});
    chart["layer"] = std::move(layers);
    return chart;
}

}  // namespace coppice::report
