#include "report/chart_parts.h"
#include "report/charts_laboratory.h"
#include "report/format.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <string>
#include <vector>

namespace coppice::report {
namespace {

using nlohmann::json;

// What a tree is called: "grown, uniform", and with its sample "grown, uniform, 10 %".
std::string builder_name(const json& tree) {
    const std::string sampler = text_at(tree, "sampler");
    return text_at(tree, "protocol") + (sampler.empty() ? "" : ", " + sampler);
}

std::string tree_name(const json& tree) {
    return builder_name(tree) + ", " +
           format_percent(number_at(tree, "sample_percent").value_or(0));
}

std::vector<double> numbers_of(const json& values, const char* key) {
    std::vector<double> numbers;
    std::ranges::transform(values, std::back_inserter(numbers),
                           [&](const json& value) { return value.at(key).get<double>(); });
    return numbers;
}

// Okabe and Ito's palette, and shapes for what is beyond it.
json builder_scale(const char* what) {
    if (std::string_view(what) == "shape") {
        return {{"range",
                 {"circle", "square", "triangle-up", "diamond", "cross", "triangle-down",
                  "triangle-right", "triangle-left"}}};
    }
    return {
        {"range", {"#d55e00", "#0072b2", "#009e73", "#cc79a7", "#e69f00", "#56b4e9", "#999999"}}};
}

json builder_encoding(const char* what) {
    return {{"field", "builder"},
            {"type", "nominal"},
            {"title", nullptr},
            {"scale", builder_scale(what)},
            {"legend", {{"columns", 2}}}};
}

// The numbers of rays that the chart is about, from well before the first change of winner to
// well behind the last: powers of ten.
struct RayRange {
    int first = 4;
    int last = 9;
};

RayRange ray_range(const json& rays) {
    RayRange range;
    for (const json& span : array_at(rays, "fastest")) {
        const double from = number_at(span, "from_rays").value_or(0.0);
        if (!(from > 0.0)) continue;
        range.first = std::min(range.first, static_cast<int>(std::floor(std::log10(from))) - 1);
        range.last = std::max(range.last, static_cast<int>(std::ceil(std::log10(from))) + 1);
    }
    range.first = std::max(range.first, 0);
    return range;
}

json image_point(const json& tree, double ray_count) {
    const double seconds = number_at(tree, "build_seconds").value_or(0.0) +
                           ray_count * number_at(tree, "ray_seconds").value_or(0.0);
    return {{"tree", tree_name(tree)},
            {"builder", builder_name(tree)},
            {"rays", rounded(ray_count)},
            {"seconds", rounded(seconds)}};
}

// A curve that is straight on neither axis needs points between.
json image_values(const json& rays, RayRange range) {
    json values = json::array();
    for (const json& tree : array_at(rays, "trees")) {
        for (int step = 2 * range.first; step <= 2 * range.last; ++step) {
            values.push_back(image_point(tree, std::pow(10.0, 0.5 * step)));
        }
    }
    return values;
}

const json* find_tree(const json& rays, const json& name) {
    for (const json& tree : array_at(rays, "trees")) {
        if (tree_name(tree) == tree_name(name)) return &tree;
    }
    return nullptr;
}

// The fastest tree at each number of rays, piece by piece.
json winner_values(const json& rays, RayRange range) {
    json values = json::array();
    for (const json& span : array_at(rays, "fastest")) {
        const json* tree = find_tree(rays, span);
        const double low = std::pow(10.0, range.first);
        const double high = std::pow(10.0, range.last);
        const double from = std::max(low, number_at(span, "from_rays").value_or(0.0));
        const double to = std::min(high, number_at(span, "to_rays").value_or(high));
        if (tree == nullptr || !(from < to)) continue;
        constexpr int step_count = 8;
        for (int step = 0; step <= step_count; ++step) {
            json value = image_point(
                *tree, from * std::pow(to / from, static_cast<double>(step) / step_count));
            value["is_start"] = step == 0 && from > low;
            values.push_back(std::move(value));
        }
    }
    return values;
}

}  // namespace

json make_cost_ray_chart(const json& scene, std::string_view form) {
    json values = json::array();
    const json& rows = array_at(scene, "rows");
    const json& details = array_at(scene, "details");
    for (std::size_t i = 0; i < rows.size() && i < details.size(); ++i) {
        const auto cost = number_at(rows[i], "sah_cost");
        const auto nanoseconds = number_at(rows[i], "ray_nanoseconds");
        if (text_at(details[i], "tree") != form || !cost || !nanoseconds) continue;
        values.push_back({{"builder", builder_name(rows[i])},
                          {"label", tree_name(rows[i])},
                          {"seed", rows[i].value("seed", json())},
                          {"cost", rounded(*cost)},
                          {"time", rounded(*nanoseconds)}});
    }
    if (values.empty()) return nullptr;
    json chart = chart_frame(fmt::format("Measured time of a ray against SAH cost, {} trees of {}",
                                         form, text_at(scene, "scene")),
                             300);
    chart["data"] = {{"values", values}};
    chart["mark"] = point_mark();
    chart["encoding"] = {
        {"x", value_axis("cost", "SAH cost", numbers_of(values, "cost"))},
        {"y", value_axis("time", "Time of a ray (ns)", numbers_of(values, "time"))},
        {"color", builder_encoding("color")},
        {"shape", builder_encoding("shape")},
        {"tooltip",
         {tip("label", "Tree"), tip("seed", "Seed"), tip("cost", "SAH cost", ",.4~r"),
          tip("time", "ns a ray", ",.4~r")}}};
    return chart;
}

json make_image_time_chart(const json& scene) {
    const json rays = scene.value("rays", json());
    if (array_at(rays, "trees").empty()) return nullptr;
    const RayRange range = ray_range(rays);
    const json values = image_values(rays, range);
    const json winners = winner_values(rays, range);
    const json tooltip{tip("tree", "Tree"), tip("rays", "Rays", ",.3~r"),
                       tip("seconds", "Seconds", ",.3~r")};
    json chart = chart_frame(
        "Seconds to an image against its number of rays, trees of " + text_at(scene, "scene"), 340);
    chart["encoding"] = {{"x", value_axis("rays", "Number of rays", numbers_of(values, "rays"))},
                         {"y", value_axis("seconds", "Seconds to the image, building included",
                                          numbers_of(values, "seconds"))}};
    chart["encoding"]["x"]["axis"]["format"] = "~s";
    const json color{{"field", "tree"},
                     {"type", "nominal"},
                     {"title", "fastest"},
                     {"sort", nullptr},
                     {"scale", builder_scale("color")},
                     {"legend", {{"columns", 2}, {"labelLimit", 320}}}};
    chart["layer"] = {
        {{"data", {{"values", values}}},
         {"mark",
          {{"type", "line"}, {"color", "currentColor"}, {"opacity", 0.25}, {"strokeWidth", 1}}},
         {"encoding",
          {{"detail", {{"field", "tree"}, {"type", "nominal"}}}, {"tooltip", tooltip}}}},
        {{"data", {{"values", winners}}},
         {"mark", {{"type", "line"}, {"strokeWidth", 4}}},
         {"encoding", {{"color", color}, {"tooltip", tooltip}}}},
        {{"data", {{"values", winners}}},
         {"transform", {{{"filter", "datum.is_start"}}}},
         {"mark", point_mark(80)},
         {"encoding", {{"color", color}, {"tooltip", tooltip}}}}};
    return chart;
}

}  // namespace coppice::report
