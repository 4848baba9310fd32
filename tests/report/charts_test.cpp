#include "report/charts.h"

#include "coppice/base/error.h"

#include "report/chart_parts.h"
#include "report/results_fixture.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

namespace coppice::report {
namespace {

using nlohmann::json;
using test::make_results;

Series series_of(const json& results) {
    return collect_series(results).front();
}

const json& values_of(const json& chart) {
    return chart.at("data").at("values");
}

json find_value(const json& chart, const std::string& protocol, double percent) {
    for (const json& value : values_of(chart)) {
        if (value["protocol"] == protocol && value["percent"] == percent) return value;
    }
    return {};
}

std::size_t count_layers(const json& chart, const std::string& mark) {
    return static_cast<std::size_t>(std::ranges::count_if(
        chart.at("layer"), [&](const json& layer) { return layer["mark"]["type"] == mark; }));
}

TEST(CostTimeChart, DrawsEveryTreeAtItsCostAndTime) {
    const json chart = make_cost_time_chart(make_results(), "dragon", "triangles");
    EXPECT_EQ(values_of(chart).size(), 12U);
    const json value = find_value(chart, "fixed limit", 1);
    EXPECT_DOUBLE_EQ(value["cost"], 88.5 * test::relative_cost("fixed", 1));
    EXPECT_DOUBLE_EQ(value["relative_cost"], test::relative_cost("fixed", 1));
    EXPECT_DOUBLE_EQ(value["time"], 0.061);
    EXPECT_EQ(value["label"], "1\u00a0%");
    EXPECT_EQ(find_value(chart, "fixed limit", 50)["recommended"], true);
    EXPECT_EQ(chart["encoding"]["color"]["scale"]["domain"],
              (json{"fixed limit", "scaled limit", "grown on"}));
}

TEST(CostTimeChart, IsNamedBySceneAndKind) {
    EXPECT_THROW((void)make_cost_time_chart(make_results(), "dragon", "spheres"), Error);
    EXPECT_THROW((void)make_cost_time_chart(make_results(), "kitchen", "points"), Error);
}

TEST(CostTimeChart, LogarithmicAxesHoldAllValues) {
    const json chart = make_cost_time_chart(series_of(make_results()));
    for (const auto& [axis, field] : {std::pair{"x", "time"}, std::pair{"y", "cost"}}) {
        const json& scale = chart["encoding"][axis]["scale"];
        EXPECT_EQ(scale["type"], "log") << axis;
        for (const json& value : values_of(chart)) {
            EXPECT_GT(value[field], scale["domain"][0]) << axis;
            EXPECT_LT(value[field], scale["domain"][1]) << axis;
        }
    }
}

TEST(CostTimeChart, TimesOfZeroForbidALogarithmicAxis) {
    json results = make_results();
    results["scenes"][0]["rows"][3]["total_seconds"] = 0.0;
    const json chart = make_cost_time_chart(series_of(results));
    EXPECT_EQ(chart["encoding"]["x"]["scale"]["type"], "linear");
    EXPECT_EQ(values_of(chart).size(), 12U);
}

TEST(CostTimeChart, NeedsNo100PercentTree) {
    json results = make_results({.percents = {50, 10}});
    for (json& row : results["scenes"][0]["rows"]) {
        row["relative_cost"] = nullptr;
    }
    const json chart = make_cost_time_chart(series_of(results));
    EXPECT_DOUBLE_EQ(find_value(chart, "fixed limit", 50)["cost"],
                     88.5 * test::relative_cost("fixed", 50));
}

TEST(CostTimeChart, OneTreeIsAChartToo) {
    const json chart = make_cost_time_chart(series_of(
        make_results({.kinds = {"triangles"}, .protocols = {"grown"}, .percents = {100}})));
    ASSERT_EQ(values_of(chart).size(), 1U);
    for (const char* axis : {"x", "y"}) {
        const json& domain = chart["encoding"][axis]["scale"]["domain"];
        EXPECT_LT(domain[0], domain[1]) << axis;
    }
}

TEST(CostTimeChart, SeedsAddRulesFromTheLeastToTheGreatest) {
    EXPECT_EQ(count_layers(make_cost_time_chart(series_of(make_results())), "rule"), 0U);
    const json chart = make_cost_time_chart(series_of(make_results({.seeds = {1, 2}})));
    EXPECT_EQ(count_layers(chart, "rule"), 2U);
    const json value = find_value(chart, "fixed limit", 100);
    EXPECT_DOUBLE_EQ(value["cost_min"], 88.5);
    EXPECT_DOUBLE_EQ(value["cost_max"], 88.5 * 1.1);
    EXPECT_DOUBLE_EQ(value["time_max"], 2.241);
}

TEST(CostTimeChart, RecommendedPointsAreLabelled) {
    const json chart = make_cost_time_chart(series_of(make_results()));
    for (const json& value : values_of(chart)) {
        if (value["recommended"] == true) {
            EXPECT_TRUE(value.contains("side")) << value;
        }
    }
}

TEST(LinearCostTimeChart, IsTheSameOnLinearAxes) {
    const json chart = make_linear_cost_time_chart(series_of(make_results()));
    EXPECT_EQ(chart["encoding"]["x"]["scale"]["type"], "linear");
    EXPECT_EQ(chart["encoding"]["y"]["scale"]["type"], "linear");
    EXPECT_DOUBLE_EQ(find_value(chart, "fixed limit", 100)["cost"], 88.5);
}

TEST(RateChart, ShowsTheMeasureWithABandOverSeeds) {
    const json one = make_rate_chart(series_of(make_results()), {"node_count", "Nodes"});
    EXPECT_EQ(count_layers(one, "area"), 0U);
    EXPECT_EQ(find_value(one, "grown on", 1)["value"], 2 * (437'645 / 8 + 1) - 1);
    const json two =
        make_rate_chart(series_of(make_results({.seeds = {1, 2}})), {"sah_cost", "Cost"});
    EXPECT_EQ(count_layers(two, "area"), 1U);
    EXPECT_DOUBLE_EQ(find_value(two, "fixed limit", 100)["value_max"], 88.5 * 1.1);
}

TEST(RateChart, SmallTimesGetASmallUnit) {
    json results = make_results();
    for (json& row : results["scenes"][0]["rows"]) {
        row["total_seconds"] = 0.002;
    }
    const json chart = make_rate_chart(series_of(results), {"total_seconds", "Build time", true});
    EXPECT_EQ(chart["encoding"]["y"]["title"], "Build time (ms)");
    EXPECT_DOUBLE_EQ(find_value(chart, "fixed limit", 10)["value"], 2.0);
}

TEST(RateChart, AMeasureThatNobodyTookIsAnEmptyChart) {
    const json chart = make_rate_chart(series_of(make_results()), {"unheard_of", "Unheard of"});
    EXPECT_TRUE(values_of(chart).empty());
    const json& domain = chart["encoding"]["y"]["scale"]["domain"];
    EXPECT_LT(domain[0], domain[1]);
}

TEST(StageChart, StacksTheFiveStagesOfAProtocolFromZero) {
    const Series series = series_of(make_results());
    const json chart = make_stage_chart(series, "grown");
    ASSERT_EQ(values_of(chart).size(), 4U * 5U);
    double sum = 0.0;
    for (const json& value : values_of(chart)) {
        if (value["label"] == "10") sum += value["time"].get<double>();
    }
    EXPECT_DOUBLE_EQ(sum, series.find("grown", 10)->find("total_seconds")->mean);
    EXPECT_EQ(chart["encoding"]["y"]["scale"]["domain"][0], 0.0);
    EXPECT_EQ(chart["encoding"]["y"], make_stage_chart(series, "fixed")["encoding"]["y"]);
}

TEST(LevelChart, OffersEveryPercentageAndShowsTheSmallest) {
    const json chart =
        make_level_chart(series_of(make_results()), {"cost_share_by_depth", "Share"});
    EXPECT_EQ(chart["params"][0]["bind"]["options"], (json{100.0, 50.0, 10.0, 1.0}));
    EXPECT_EQ(chart["params"][0]["value"], 1.0);
    EXPECT_EQ(values_of(chart).size(), 12U * 4U);
    EXPECT_EQ(chart["layer"].size(), 3U);  // the full tree, lines, points
    const json part = make_level_chart(series_of(make_results({.percents = {50}})),
                                       {"cost_share_by_depth", "Share"});
    EXPECT_EQ(part["layer"].size(), 2U);
}

TEST(ThesisChart, ShowsOursBesideTheFourScenes) {
    const json chart =
        make_thesis_chart(series_of(make_results()), thesis_tables(), ThesisMeasure::cost);
    const auto count_of = [&](const char* source) {
        return std::ranges::count_if(values_of(chart),
                                     [&](const json& value) { return value["source"] == source; });
    };
    EXPECT_EQ(count_of("fixed limit"), 4);
    EXPECT_EQ(count_of("thesis: dragon"), 11);
    EXPECT_EQ(chart["encoding"]["color"]["scale"]["domain"].size(), 7U);
    for (const json& value : values_of(chart)) {
        if (value["source"] == "thesis: dragon" && value["percent"] == 1.0) {
            EXPECT_NEAR(value["value"], 49.1755 / 29.94, 1e-5);
        }
    }
}

TEST(ThesisChart, LeavesOutTheThesissZeroSeconds) {
    const json chart =
        make_thesis_chart(series_of(make_results()), thesis_tables(), ThesisMeasure::build_time);
    for (const json& value : values_of(chart)) {
        EXPECT_GT(value["value"], 0.0) << value;
    }
    EXPECT_EQ(chart["encoding"]["y"]["scale"]["type"], "log");
}

TEST(PercentAxis, FallsFromLeftToRightWithoutCrowdedTicks) {
    const json axis = percent_axis({100, 50, 40, 30, 20, 10, 5, 4, 3, 2, 1});
    EXPECT_EQ(axis["sort"], "descending");
    std::vector<double> ticks = axis["axis"]["values"];
    std::ranges::sort(ticks, std::greater<>());
    EXPECT_EQ(ticks, (std::vector<double>{100, 50, 20, 10, 5, 2, 1}));
    EXPECT_EQ(percent_axis({0.1})["axis"]["values"], json{0.1});
}

TEST(ValueAxis, IsLogarithmicOnlyWhereValuesSpreadAndNoneIsZero) {
    EXPECT_EQ(value_axis("v", "", {1, 47})["scale"]["type"], "log");
    EXPECT_EQ(value_axis("v", "", {0, 47})["scale"]["type"], "linear");
    EXPECT_EQ(value_axis("v", "", {1, 2})["scale"]["type"], "linear");
    EXPECT_EQ(value_axis("v", "", {1, 2})["scale"]["domain"][0], 0.0);
    EXPECT_GT(value_axis("v", "", {88, 92})["scale"]["domain"][0], 80.0);
    EXPECT_EQ(value_axis("v", "", {1, 47})["axis"]["values"], (json{1, 2, 5, 10, 20, 50}));
}

}  // namespace
}  // namespace coppice::report
