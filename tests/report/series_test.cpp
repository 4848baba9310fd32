#include "report/series.h"

#include "coppice/base/error.h"

#include "report/results_fixture.h"

#include <gtest/gtest.h>

#include <set>

namespace coppice::report {
namespace {

using test::make_results;

TEST(CollectSeries, FindsEverySceneAndKindInOrder) {
    const auto series = collect_series(make_results({.scenes = {"kitchen", "dragon"}}));
    ASSERT_EQ(series.size(), 4U);
    EXPECT_EQ(series[0].key, "kitchen-points");
    EXPECT_EQ(series[1].key, "kitchen-triangles");
    EXPECT_EQ(series[3].scene, "dragon");
    EXPECT_EQ(series[3].scene_index, 1U);
    EXPECT_EQ(series[3].protocols(), (std::vector<std::string>{"fixed", "scaled", "grown"}));
    EXPECT_EQ(series[3].percents(), (std::vector<double>{100, 50, 10, 1}));
}

TEST(CollectSeries, SortsProtocolsAndPercentagesWhateverTheRowsOrder) {
    const auto series = collect_series(
        make_results({.protocols = {"other", "grown", "fixed"}, .percents = {1, 100, 10}}));
    EXPECT_EQ(series[0].protocols(), (std::vector<std::string>{"fixed", "grown", "other"}));
    EXPECT_EQ(series[0].points.front().percent, 100.0);
    EXPECT_EQ(series[0].points[2].percent, 1.0);
}

TEST(CollectSeries, KeysAreUniqueForScenesThatLookAlike) {
    const auto series = collect_series(make_results({.scenes = {"a b", "a-b", "A B", "???", "!"}}));
    std::set<std::string> keys;
    for (const Series& one : series) {
        keys.insert(one.key);
    }
    EXPECT_EQ(keys.size(), series.size());
}

TEST(CollectSeries, AveragesTheSeedsAndKeepsTheirEnds) {
    const auto series = collect_series(make_results({.seeds = {1, 2, 3}}));
    const RatePoint* point = series[0].find("fixed", 100);
    ASSERT_NE(point, nullptr);
    EXPECT_EQ(point->seed_count, 3U);
    const Range* cost = point->find("relative_cost");
    ASSERT_NE(cost, nullptr);
    EXPECT_DOUBLE_EQ(cost->mean, 1.1);
    EXPECT_DOUBLE_EQ(cost->min, 1.0);
    EXPECT_DOUBLE_EQ(cost->max, 1.2);
    EXPECT_EQ(point->levels.at("depth_histogram"), (std::vector<double>{0, 1, 2, 8}));
    EXPECT_DOUBLE_EQ(point->find("expected_inner_visits")->mean, 50.0);
}

TEST(CollectSeries, LevelsOfSeedsMayDifferInNumber) {
    nlohmann::json results = make_results({.seeds = {1, 2}});
    results["scenes"][0]["details"][0]["depth_histogram"] = {2, 6};
    const auto series = collect_series(results);
    EXPECT_EQ(series[0].find("fixed", 100)->levels.at("depth_histogram"),
              (std::vector<double>{1, 3.5, 1, 4}));
}

TEST(CollectSeries, MarksWhatIsRecommended) {
    const auto series = collect_series(make_results());
    EXPECT_TRUE(series[0].find("fixed", 50)->is_recommended);
    EXPECT_FALSE(series[0].find("fixed", 10)->is_recommended);
}

TEST(CollectSeries, WithoutA100PercentRowNothingIsRelativeInTime) {
    const auto series = collect_series(make_results({.percents = {50, 10}}));
    EXPECT_EQ(series[0].relative_to_full(series[0].points[0], "total_seconds"), std::nullopt);
    EXPECT_TRUE(series[0].has_relative_cost());  // the lab still knows it
}

TEST(CollectSeries, NullsAreNotNumbers) {
    nlohmann::json results = make_results();
    results["scenes"][0]["rows"][0]["relative_cost"] = nullptr;
    const auto series = collect_series(results);
    EXPECT_FALSE(series[0].has_relative_cost());
    EXPECT_TRUE(series[1].has_relative_cost());
    EXPECT_EQ(series[0].points[0].find("relative_cost"), nullptr);
}

TEST(CollectSeries, RelativeToFullDividesMeans) {
    const auto series = collect_series(make_results());
    const RatePoint* point = series[0].find("fixed", 50);
    EXPECT_DOUBLE_EQ(*series[0].relative_to_full(*point, "total_seconds"), 1.041 / 2.041);
    EXPECT_EQ(series[0].relative_to_full(*point, "empty_seconds"), std::nullopt);  // 0 / 0
    EXPECT_EQ(series[0].relative_to_full(*point, "no such measure"), std::nullopt);
}

TEST(CollectSeries, RefusesWhatIsNoResultsDocument) {
    for (const char* text : {"[]", "3", "{}", R"({"scenes": {}})", R"({"scenes": [1]})"}) {
        EXPECT_THROW((void)collect_series(nlohmann::json::parse(text)), Error) << text;
    }
    EXPECT_TRUE(collect_series(make_results({.scenes = {}})).empty());
}

}  // namespace
}  // namespace coppice::report
