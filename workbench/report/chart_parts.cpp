#include "report/chart_parts.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace coppice::report {
namespace {

using nlohmann::json;

// From this ratio of greatest to least on, small values vanish on a linear axis.
constexpr double log_ratio = 8.0;
// Below this ratio an axis from 0 would show nothing but a flat line.
constexpr double flat_ratio = 1.5;

const char* const font = "system-ui, -apple-system, 'Segoe UI', Roboto, sans-serif";

// Text and rules take the colour of the text around the chart: one drawing serves light, dark
// and paper.
json chart_config() {
    const json faint{{"gridColor", "currentColor"},   {"gridOpacity", 0.12},
                     {"domainColor", "currentColor"}, {"domainOpacity", 0.45},
                     {"tickColor", "currentColor"},   {"tickOpacity", 0.45},
                     {"labelColor", "currentColor"},  {"titleColor", "currentColor"},
                     {"labelFontSize", 12},           {"titleFontSize", 12},
                     {"titleFontWeight", 500},        {"titlePadding", 8}};
    return {{"font", font},
            {"view", {{"stroke", nullptr}}},
            {"axis", faint},
            {"legend",
             {{"orient", "top"},
              {"labelColor", "currentColor"},
              {"titleColor", "currentColor"},
              {"labelFontSize", 12},
              {"symbolOpacity", 1},
              {"labelLimit", 240},
              {"columnPadding", 10}}}};
}

struct Extent {
    double min = 0.0;
    double max = 0.0;
};

Extent extent_of(const std::vector<double>& values) {
    if (values.empty()) return {0.0, 1.0};
    const auto [least, greatest] = std::ranges::minmax(values);
    return {least, greatest};
}

// 1, 2, 5, 10, 20, 50, ... within the ends; only the powers of ten where those are many.
std::vector<double> log_ticks(double low, double high) {
    std::vector<double> ticks;
    const bool is_bvh8 = high / low > 2e3;
    for (double decade = std::pow(10.0, std::floor(std::log10(low))); decade <= high;
         decade *= 10.0) {
        for (const double step : {1.0, 2.0, 5.0}) {
            const double tick = decade * step;
            if (tick >= low && tick <= high && (step == 1.0 || !is_bvh8)) ticks.push_back(tick);
        }
    }
    return ticks;
}

// Both ends lie `margin` of the axis beyond the values.
json log_axis(const std::string& field, const std::string& title, Extent extent, double margin) {
    const double beyond =
        std::max(std::pow(extent.max / extent.min, margin / (1.0 - 2.0 * margin)), 1.01);
    const double low = extent.min / beyond;
    const double high = extent.max * beyond;
    return {{"field", field},
            {"type", "quantitative"},
            {"title", title},
            {"scale", {{"type", "log"}, {"domain", {low, high}}, {"nice", false}}},
            {"axis", {{"values", log_ticks(low, high)}, {"format", ",~r"}}}};
}

json protocol_scale(const std::vector<std::string>& protocols,
                    std::string ProtocolStyle::*range_member) {
    json domain = json::array();
    json range = json::array();
    for (const std::string& protocol : protocols) {
        const ProtocolStyle style = protocol_style(protocol);
        domain.push_back(style.label);
        range.push_back(style.*range_member);
    }
    json encoding{{"field", "protocol"},
                  {"type", "nominal"},
                  {"title", nullptr},
                  {"scale", {{"domain", domain}, {"range", range}}}};
    if (protocols.size() > 3) encoding["legend"] = {{"columns", 2}};
    return encoding;
}

// A protocol with another sampler than usual: its colour, lighter or darker, and another shape.
ProtocolStyle sampler_style(std::string_view line, std::size_t comma) {
    ProtocolStyle style = protocol_style(line.substr(0, comma));
    const std::string sampler(line.substr(comma));
    const bool is_light = sampler == ", stratified";
    const unsigned long color = std::stoul(style.color.substr(1), nullptr, 16);
    std::string mixed = "#";
    for (const unsigned shift : {16U, 8U, 0U}) {
        const unsigned long part = color >> shift & 255U;
        mixed += fmt::format("{:02x}", is_light ? (part + 255U) / 2U : part * 6U / 10U);
    }
    const std::string short_label = style.label.substr(0, style.label.find(' '));
    return {style.name + sampler, short_label + sampler, mixed,
            is_light ? "triangle-down" : "cross"};
}

}  // namespace

ProtocolStyle protocol_style(std::string_view protocol) {
    if (protocol == "fixed") return {"fixed leaf limit", "fixed limit", "#d55e00", "circle"};
    if (protocol == "scaled") return {"scaled leaf limit", "scaled limit", "#0072b2", "square"};
    if (protocol == "grown") return {"leaves grown on", "grown on", "#009e73", "triangle-up"};
    const std::size_t comma = protocol.find(", ");
    if (comma != std::string_view::npos) return sampler_style(protocol, comma);
    const std::string name(protocol);
    if (protocol == "exact") return {name, name, "#e69f00", "diamond"};
    if (protocol == "binned") return {name, name, "#56b4e9", "cross"};
    return {name, name, "#cc79a7", protocol == "sampled" ? "triangle-down" : "diamond"};
}

TimeUnit time_unit(double greatest_seconds) {
    if (greatest_seconds >= 0.1 || greatest_seconds == 0.0) return {"s", 1.0};
    if (greatest_seconds >= 1e-4) return {"ms", 1e3};
    return {"µs", 1e6};
}

TimeUnit time_unit(const Series& series, std::string_view key) {
    const std::vector<double> ends = collect_ends(series, key);
    return time_unit(ends.empty() ? 0.0 : std::ranges::max(ends));
}

std::vector<double> collect_ends(const Series& series, std::string_view key, double factor) {
    std::vector<double> ends;
    for (const RatePoint& point : series.points) {
        if (const Range* range = point.find(key)) {
            ends.push_back(range->band_low() * factor);
            ends.push_back(range->band_high() * factor);
        }
    }
    return ends;
}

bool has_intervals(const Series& series, std::string_view key) {
    return std::ranges::any_of(series.points, [&](const RatePoint& point) {
        const Range* range = point.find(key);
        return range != nullptr && range->interval;
    });
}

bool has_seeds(const Series& series) {
    return std::ranges::any_of(series.points, [](const RatePoint& p) { return p.seed_count > 1; });
}

void put_range(json& value, const std::string& field, const Range& range, double factor) {
    value[field] = range.mean * factor;
    value[field + "_min"] = range.band_low() * factor;
    value[field + "_max"] = range.band_high() * factor;
}

double rounded(double value) {
    return value == 0.0 ? 0.0 : std::stod(fmt::format("{:.6g}", value));
}

json line_mark() {
    return {{"type", "line"}, {"strokeWidth", 2}};
}

json point_mark(int size) {
    return {{"type", "point"}, {"filled", true}, {"opacity", 1}, {"size", size}};
}

json chart_frame(const std::string& description, int height) {
    return {{"description", description},
            {"width", "container"},
            {"height", height},
            {"background", "white"},
            {"config", chart_config()}};
}

json protocol_color(const std::vector<std::string>& protocols) {
    return protocol_scale(protocols, &ProtocolStyle::color);
}

json protocol_shape(const std::vector<std::string>& protocols) {
    return protocol_scale(protocols, &ProtocolStyle::shape);
}

bool wants_log(const std::vector<double>& values) {
    const Extent extent = extent_of(values);
    return extent.min > 0.0 && extent.max / extent.min >= log_ratio;
}

json value_axis(const std::string& field, const std::string& title,
                const std::vector<double>& values) {
    return wants_log(values) ? log_axis(field, title, extent_of(values), 0.07)
                             : linear_axis(field, title, values);
}

json linear_axis(const std::string& field, const std::string& title,
                 const std::vector<double>& values) {
    Extent extent = extent_of(values);
    const bool is_flat =
        extent.min > 0.0 && extent.min < extent.max && extent.max / extent.min < flat_ratio;
    if (!is_flat) extent.min = std::min(extent.min, 0.0);
    const bool is_whole = std::ranges::all_of(
        values, [](double value) { return value == std::floor(value) && value != 0.0; });
    if (extent.min == extent.max) extent.max = extent.min + 1.0;
    const double margin = 0.06 * (extent.max - extent.min);
    return {{"field", field},
            {"type", "quantitative"},
            {"title", title},
            {"scale",
             {{"type", "linear"},
              {"domain", {is_flat ? extent.min - margin : extent.min, extent.max + margin}},
              {"nice", false},
              {"zero", false}}},
            {"axis", {{"format", ",~r"}, {"tickCount", 6}, {"tickMinStep", is_whole ? 1.0 : 0.0}}}};
}

json percent_axis(const std::vector<double>& percents) {
    json axis = log_axis("percent", "Sample (% of the primitives)", extent_of(percents), 0.03);
    axis["sort"] = "descending";
    // The ends and round numbers first; what would stand too close to a chosen one is left out.
    std::vector<double> wanted = percents;
    const auto roundness = [&](double percent) {
        if (percent == percents.front() || percent == percents.back()) return 0;
        const double mantissa = percent / std::pow(10.0, std::floor(std::log10(percent)));
        return mantissa == 1.0 ? 1 : mantissa == 5.0 ? 2 : mantissa == 2.0 ? 3 : 4;
    };
    std::ranges::stable_sort(wanted, {}, roundness);
    const double closest = 0.1 * std::log10(extent_of(percents).max / extent_of(percents).min);
    std::vector<double> ticks;
    for (const double percent : wanted) {
        const bool is_free = std::ranges::all_of(
            ticks, [&](double tick) { return std::abs(std::log10(percent / tick)) >= closest; });
        if (is_free) ticks.push_back(percent);
    }
    axis["axis"] = {{"values", ticks}, {"format", "~r"}};
    return axis;
}

json tip(const std::string& field, const std::string& title, const std::string& format) {
    json line{{"field", field}, {"title", title}};
    if (!format.empty()) line["format"] = format;
    return line;
}

double axis_position(const json& axis, double value) {
    const json& scale = axis.at("scale");
    double low = scale.at("domain").at(0).get<double>();
    double high = scale.at("domain").at(1).get<double>();
    if (scale.at("type") == "log") {
        low = std::log(low);
        high = std::log(high);
        value = std::log(value);
    }
    return (value - low) / (high - low);
}

}  // namespace coppice::report
