#include "compare/compare.h"

#include "coppice/base/error.h"

#include "support/lab_scenes.h"

#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

namespace coppice::lab {

namespace {

using nlohmann::json;
using testing::ElementsAre;
using testing::HasSubstr;

/// An experiment of two rows and so many seeds; costs and times differ a little by seed.
json make_experiment(int seed_count) {
    json rows = json::array();
    for (const double percent : {100.0, 10.0}) {
        for (int seed = 1; seed <= seed_count; ++seed) {
            rows.push_back({{"scene", "ball"},
                            {"primitives", "points"},
                            {"protocol", "grown"},
                            {"sampler", "uniform"},
                            {"sample_percent", percent},
                            {"seed", seed},
                            {"sah_cost", 80.0 + seed},
                            {"total_seconds", 1.0 + 0.1 * seed}});
        }
    }
    return {{"machine", {{"cpu", "x"}, {"cores", 2}}},
            {"options", {{"split", "sah"}}},
            {"scenes", {{{"scene", "ball"}, {"rows", rows}}}}};
}

/// Multiplies a measure of the rows at 10 % by a factor and, by seed, a little more.
json changed(json document, const char* key, double factor, double by_seed = 0.0) {
    for (json& row : document["scenes"][0]["rows"]) {
        if (row["sample_percent"] != 10.0) continue;
        row[key] = row[key].get<double>() * (factor + by_seed * (row["seed"].get<int>() - 2));
    }
    return document;
}

std::vector<std::string> findings(const json& before, const json& after,
                                  const CompareOptions& options = {}) {
    std::vector<std::string> texts;
    for (const Difference& found : compare_results(before, after, options).differences) {
        texts.push_back((found.is_worse ? "worse: " : "better: ") + found.row + ": " +
                        found.measure);
    }
    return texts;
}

TEST(Compare, FindsNothingBetweenEqualResults) {
    for (const int seed_count : {1, 3}) {
        const json document = make_experiment(seed_count);
        const Comparison comparison = compare_results(document, document, {});
        EXPECT_EQ(comparison.row_count, 2U);
        EXPECT_EQ(comparison.figure_count, 4U);
        EXPECT_TRUE(comparison.differences.empty());
        EXPECT_TRUE(comparison.notes.empty());
    }
}

TEST(Compare, JudgesSingleTreesByTolerances) {
    const json before = make_experiment(1);
    EXPECT_TRUE(findings(before, changed(before, "sah_cost", 1.009)).empty());
    EXPECT_THAT(findings(before, changed(before, "sah_cost", 1.011)),
                ElementsAre("worse: ball, points, grown, 10 %: sah_cost"));
    EXPECT_THAT(findings(before, changed(before, "sah_cost", 0.98)),
                ElementsAre("better: ball, points, grown, 10 %: sah_cost"));
    EXPECT_TRUE(findings(before, changed(before, "total_seconds", 1.2)).empty());
    EXPECT_THAT(findings(before, changed(before, "total_seconds", 1.3)),
                ElementsAre("worse: ball, points, grown, 10 %: total_seconds"));
    EXPECT_TRUE(findings(before, changed(before, "sah_cost", 1.05), {.tolerance = 0.1}).empty());
}

TEST(Compare, JudgesSeedsByTheirInterval) {
    const json before = make_experiment(3);
    // The same for every seed: sure, however little it is.
    EXPECT_EQ(findings(before, changed(before, "sah_cost", 1.001)).size(), 1U);
    // +1 % on average, but from -4 % to +6 %.
    EXPECT_TRUE(findings(before, changed(before, "sah_cost", 1.01, 0.05)).empty());
    // Times drift: what is sure must be large besides.
    EXPECT_TRUE(findings(before, changed(before, "total_seconds", 1.2)).empty());
    EXPECT_EQ(findings(before, changed(before, "total_seconds", 1.5, 0.01)).size(), 1U);
    EXPECT_TRUE(findings(before, changed(before, "total_seconds", 1.5, 0.5)).empty());
}

TEST(Compare, NamesRowsThatOneFileLacksAndWhatElseIsDifferent) {
    const json before = make_experiment(1);
    json after = before;
    after["scenes"][0]["rows"].erase(1);
    after["machine"]["cpu"] = "y";
    after["options"]["split"] = "binned";
    Comparison comparison = compare_results(before, after, {});
    EXPECT_EQ(comparison.row_count, 1U);
    EXPECT_THAT(comparison.only_before, ElementsAre("ball, points, grown, 10 %"));
    EXPECT_THAT(comparison.notes, ElementsAre(HasSubstr("machines differ"), HasSubstr("split")));
    comparison = compare_results(after, before, {});
    EXPECT_THAT(comparison.only_after, ElementsAre("ball, points, grown, 10 %"));
    EXPECT_THAT(comparison_text(comparison, {}), HasSubstr("only in B: ball, points, grown, 10 %"));
}

TEST(Compare, ComparesWhatRaysTookKindByKind) {
    json before = make_experiment(1);
    for (json& row : before["scenes"][0]["rows"]) {
        row.update({{"axis_mrays", 2.0}, {"axis_nodes", 20.0}, {"mismatches", 0}});
    }
    before["scenes"][0]["rays"] = {{"camera", {{"fov", 45}}}, {"ray_counts", {{"axis", 9}}}};
    EXPECT_EQ(compare_results(before, before, {}).figure_count, 10U);
    EXPECT_THAT(findings(before, changed(before, "axis_mrays", 0.5)),
                ElementsAre("worse: ball, points, grown, 10 %: axis_mrays"));
    EXPECT_TRUE(findings(before, changed(before, "axis_mrays", 0.9)).empty());
    EXPECT_THAT(findings(before, changed(before, "axis_nodes", 1.1)),
                ElementsAre("worse: ball, points, grown, 10 %: axis_nodes"));
    json after = changed(before, "axis_nodes", 1.1);
    after["scenes"][0]["rays"]["camera"]["fov"] = 60;  // other rays
    const Comparison comparison = compare_results(before, after, {});
    EXPECT_TRUE(comparison.differences.empty());
    EXPECT_THAT(comparison.notes, ElementsAre(HasSubstr("the rays of ball")));
}

TEST(Compare, KnowsWhichWayABenchmarkGetsWorse) {
    const json row{{"scene", "ball"},       {"method", "fast"},    {"threads", 1},
                   {"build_seconds", 1.0},  {"sah_cost", nullptr}, {"bytes_per_triangle", 50.0},
                   {"primary_mrays", 10.0}, {"mismatches", 0}};
    const json before{{"rows", {row}}};
    const auto finds = [&](const char* key, double value) {
        json after = before;
        after["rows"][0][key] = value;
        return findings(before, after);
    };
    EXPECT_THAT(finds("primary_mrays", 7.0),
                ElementsAre("worse: ball, fast, 1 thread: primary_mrays"));
    EXPECT_THAT(finds("primary_mrays", 15.0), ElementsAre(HasSubstr("better: ")));
    EXPECT_THAT(finds("build_seconds", 0.7), ElementsAre(HasSubstr("better: ")));
    EXPECT_THAT(finds("mismatches", 1), ElementsAre(HasSubstr("worse: ")));
    EXPECT_TRUE(finds("sah_cost", 3.0).empty());
}

TEST(Compare, TakesTimesOfLessThanTwoMillisecondsApartAsEqual) {
    const json before = changed(make_experiment(1), "total_seconds", 1e-3);
    EXPECT_TRUE(findings(before, changed(before, "total_seconds", 2.0)).empty());
    EXPECT_EQ(findings(before, changed(before, "total_seconds", 5.0)).size(), 1U);
}

TEST(Compare, RefusesWhatCannotBeCompared) {
    const json experiment = make_experiment(1);
    json other = experiment;
    for (json& row : other["scenes"][0]["rows"]) {
        row["scene"] = "cube";
    }
    json broken = experiment;
    broken["scenes"][0]["rows"][0].erase("seed");
    const json bench{{"rows", json::array()}};
    for (const json& document : {other, broken, bench, json(3), json::array()}) {
        EXPECT_THROW(static_cast<void>(compare_results(experiment, document, {})), Error);
    }
}

TEST(LoadResults, OpensAFileOrTheOneInAFolder) {
    const test::TemporaryFolder folder;
    const json document = make_experiment(1);
    const auto file = folder.make_file("results.json", document.dump());
    EXPECT_EQ(load_results(file), document);
    EXPECT_EQ(load_results(folder.path()), document);
    for (const auto& bad : {folder.path() / "missing", folder.make_file("a.json", "{"),
                            folder.make_file("b.json", "{}"), folder.make_file("c.json", "")}) {
        EXPECT_THROW(static_cast<void>(load_results(bad)), Error) << bad;
    }
}

}  // namespace

}  // namespace coppice::lab
