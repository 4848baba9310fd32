#include "report/chart_parts.h"
#include "report/charts_laboratory.h"
#include "report/format.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <map>
#include <string>
#include <vector>

namespace coppice::report {
namespace {

using nlohmann::json;

constexpr std::array<StackPart, 5> parts{{{"early_stop", "early stop", "#d55e00"},
                                          {"empty_cells", "cells not empty", "#cc79a7"},
                                          {"duplicates", "duplicates", "#e69f00"},
                                          {"plane_error", "plane error", "#0072b2"},
                                          {"uneven_leaves", "uneven leaves", "#999999"}}};

// Means over the seeds, by falling percentage and then by part.
struct PartMeans {
    std::map<double, std::array<double, parts.size()>, std::greater<>> sums;
    std::map<double, double> counts;
};

PartMeans collect_parts(const json& scene, const Series& series, std::string_view line) {
    PartMeans means;
    for (const json& row : array_at(scene, "decomposition")) {
        const auto percent = number_at(row, "sample_percent");
        if (text_at(row, "primitives") != series.kind || series.line_of(row) != line || !percent) {
            continue;
        }
        means.counts[*percent] += 1.0;
        for (std::size_t i = 0; i < parts.size(); ++i) {
            means.sums[*percent][i] += number_at(row, parts[i].key).value_or(0.0);
        }
    }
    return means;
}

json part_color() {
    json names = json::array();
    json colors = json::array();
    for (const StackPart& part : parts) {
        names.push_back(part.label);
        colors.push_back(part.color);
    }
    return {{"field", "part"},
            {"type", "nominal"},
            {"title", nullptr},
            {"scale", {{"domain", names}, {"range", colors}}},
            {"legend", {{"columns", 2}}}};
}

bool has_level_costs(const RatePoint* point) {
    return point != nullptr && point->levels.contains("cost_share_by_depth") &&
           point->find("sah_cost") != nullptr;
}

json level_costs(const RatePoint& point) {
    json values = json::array();
    const std::vector<double>& shares = point.levels.find("cost_share_by_depth")->second;
    const double cost = point.find("sah_cost")->mean;
    for (std::size_t level = 0; level < shares.size(); ++level) {
        values.push_back({{"level", level},
                          {"cost", rounded(shares[level] * cost)},
                          {"tree", format_percent(point.percent)}});
    }
    return values;
}

}  // namespace

json make_decomposition_chart(const json& scene, const Series& series, std::string_view line) {
    const PartMeans means = collect_parts(scene, series, line);
    if (means.sums.empty()) return nullptr;
    json values = json::array();
    for (const auto& [percent, sums] : means.sums) {
        for (std::size_t i = 0; i < parts.size(); ++i) {
            values.push_back({{"label", fmt::format("{:.6g}", percent)},
                              {"part", parts[i].label},
                              {"part_index", i},
                              {"share", rounded(sums[i] / means.counts.at(percent))}});
        }
    }
    json chart =
        chart_frame(fmt::format("What the trees cost beyond the full tree, by cause, {}, {} of {}",
                                protocol_style(line).label, series.kind, series.scene),
                    220);
    chart["data"] = {{"values", values}};
    chart["mark"] = {{"type", "bar"}};
    chart["encoding"] = {{"x",
                          {{"field", "label"},
                           {"type", "ordinal"},
                           {"sort", nullptr},
                           {"title", "Sample (% of the primitives)"},
                           {"axis", {{"labelAngle", 0}}}}},
                         {"y",
                          {{"field", "share"},
                           {"type", "quantitative"},
                           {"title", "Share of the full tree's cost"},
                           {"axis", {{"format", "~%"}, {"tickCount", 6}}}}},
                         {"order", {{"field", "part_index"}, {"type", "quantitative"}}},
                         {"color", part_color()},
                         {"tooltip",
                          {tip("part", "Cause"), tip("label", "Sample (%)"),
                           tip("share", "Of the full cost", ".2~%")}}};
    return chart;
}

TreePairPoints find_tree_pair(const Series& series) {
    TreePairPoints pair;
    for (const std::string& line : series.protocols()) {
        const RatePoint* full = series.find(line, 100.0);
        const RatePoint* sampled = nullptr;
        for (const RatePoint& point : series.points) {
            if (point.protocol != line || point.percent == 100.0) continue;
            const bool is_better =
                sampled == nullptr || point.is_recommended || !sampled->is_recommended;
            if (is_better) sampled = &point;
        }
        if (!has_level_costs(full) || !has_level_costs(sampled)) continue;
        const bool is_usual = line.find(", ") == std::string::npos;  // by the usual sampler
        if (pair.full == nullptr || is_usual) pair = {full, sampled};
    }
    return pair;
}

json make_pair_level_chart(const Series& series) {
    const TreePairPoints pair = find_tree_pair(series);
    if (pair.full == nullptr) return nullptr;
    json values = level_costs(*pair.full);
    for (json& value : level_costs(*pair.sampled)) {
        values.push_back(std::move(value));
    }
    const json names{format_percent(pair.full->percent), format_percent(pair.sampled->percent)};
    json chart = chart_frame(
        fmt::format("Cost at each level of two trees, {}, {} of {}",
                    protocol_style(pair.full->protocol).label, series.kind, series.scene),
        220);
    chart["data"] = {{"values", values}};
    chart["mark"] = {{"type", "bar"}};
    chart["encoding"] = {
        {"x",
         {{"field", "level"},
          {"type", "ordinal"},
          {"title", "Level of the tree"},
          {"axis", {{"labelAngle", 0}, {"labelOverlap", true}}}}},
        {"xOffset", {{"field", "tree"}, {"sort", names}}},
        {"y",
         {{"field", "cost"},
          {"type", "quantitative"},
          {"title", "SAH cost at the level"},
          {"axis", {{"tickCount", 6}}}}},
        {"color",
         {{"field", "tree"},
          {"type", "nominal"},
          {"title", nullptr},
          {"scale", {{"domain", names}, {"range", {"#0072b2", "#e69f00"}}}}}},
        {"tooltip",
         {tip("tree", "Sample"), tip("level", "Level"), tip("cost", "SAH cost", ",.4~r")}}};
    return chart;
}

}  // namespace coppice::report
