#include "report/summary.h"

#include "report/results_fixture.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace coppice::report {
namespace {

using nlohmann::json;
using test::make_results;
using testing::HasSubstr;
using testing::Not;

std::string answer_of(const json& results) {
    return make_answer(results["scenes"][0], collect_series(results));
}

std::string comparison_of(const json& results) {
    return make_thesis_comparison(collect_series(results).front(), thesis_tables());
}

TEST(Answer, IsTheSmallestSampleOfTrianglesAndWhatItCosts) {
    json results = make_results({.protocols = {"fixed", "grown"}});
    json& recommended = results["scenes"][0]["recommended"];  // two of points, two of triangles
    recommended[0]["sample_percent"] = 1;
    recommended[3]["sample_percent"] = 10;
    const std::string answer = answer_of(results);
    EXPECT_THAT(answer, HasSubstr("Build on <strong>10\u00a0%</strong> of the triangles (leaves "
                                  "grown on): the tree costs <strong>1.02 times</strong> as much "
                                  "as the full one and takes <strong>25.0\u00a0%</strong> of its "
                                  "build time."));
    EXPECT_THAT(answer, HasSubstr("Rule: Kneedle, Satopaa et al. 2011."));
}

TEST(Answer, TakesTheCheaperTreeOfEqualSamplesAndPointsWithoutTriangles) {
    const json results = make_results({.kinds = {"points"}, .protocols = {"fixed", "grown"}});
    EXPECT_THAT(answer_of(results),
                HasSubstr("50\u00a0%</strong> of the points (leaves grown on)"));
}

TEST(Answer, SaysThatNoSmallerSampleWillDo) {
    json results = make_results({.kinds = {"triangles"}, .protocols = {"fixed"}});
    results["scenes"][0]["recommended"][0]["sample_percent"] = 100;
    EXPECT_THAT(answer_of(results), HasSubstr("100\u00a0%</strong> of the triangles: no smaller"));
}

TEST(Answer, SaysWhenThereIsNone) {
    EXPECT_THAT(answer_of(make_results({.percents = {100}})), HasSubstr("recommend no percentage"));
    EXPECT_THAT(answer_of(make_results({.kinds = {}})), HasSubstr("No tree was built"));
}

TEST(Answer, EscapesWhatTheResultsSay) {
    json results = make_results();
    results["scenes"][0]["recommended"][0]["source"] = "<i>x</i>";
    EXPECT_THAT(answer_of(results), Not(HasSubstr("<i>")));
}

TEST(Findings, AreTheNumbersOfTheSmallestSample) {
    const std::string findings = make_findings(collect_series(make_results()).front());
    // 100^0.8 = 39.8, 2^0.8 = 1.74, 0.061 s of 2.041 s.
    EXPECT_THAT(findings,
                HasSubstr("<b>Fixed leaf limit:</b> the tree built on 1\u00a0% costs "
                          "<strong>39.8 times</strong> as much as its own full tree and takes "
                          "2.99\u00a0% of that one’s build time; at the thesis’s choice of "
                          "50&nbsp;% the cost is 1.74 times."));
    EXPECT_THAT(findings, HasSubstr("hold 799 primitives (full tree: 8.00)"));
    EXPECT_THAT(findings, HasSubstr("log₂(1/r) = 6.64"));
    EXPECT_THAT(findings, HasSubstr("<strong>1.03 times</strong>"));  // grown
    EXPECT_THAT(findings, HasSubstr("the SAH cost is 88.5 with a fixed leaf limit"));
}

TEST(Findings, AverageTheLevelsOfAllLeaves) {
    json results = make_results();
    for (json& detail : results["scenes"][0]["details"]) {
        const bool is_full = detail["sample_percent"] == 100.0;
        detail["depth_histogram"] = is_full ? json{0, 0, 1, 2, 1} : json{0, 1, 3};
    }
    EXPECT_THAT(make_findings(collect_series(results).front()),
                HasSubstr("its leaves lie at level 1.75 (full tree: 3.00)"));
}

TEST(Findings, GiveTheSpreadOverSeeds) {
    const std::string findings =
        make_findings(collect_series(make_results({.seeds = {1, 2}})).front());
    EXPECT_THAT(findings, HasSubstr("41.8 times (39.8 to 43.8 over 2 seeds)"));
}

TEST(Findings, ClaimNothingRelativeOfAFullTreeAlone) {
    const std::string findings =
        make_findings(collect_series(make_results({.percents = {100}})).front());
    EXPECT_THAT(findings, HasSubstr("the tree built on 100\u00a0% has the SAH cost 88.5."));
    EXPECT_THAT(findings, Not(HasSubstr("times")));
}

TEST(ThesisComparison, QuotesBothSides) {
    const std::string text = comparison_of(make_results());
    EXPECT_THAT(text, HasSubstr("At 50\u00a0% the thesis reports 1.04 to 1.21 times"));
    EXPECT_THAT(text, HasSubstr("At 1\u00a0% the thesis reports 1.64 to 2.73 times"));
    EXPECT_THAT(text, HasSubstr("give 39.8 (fixed leaf limit), 6.31 (scaled leaf limit) and 1.03 "
                                "(leaves grown on)"));
    // Primitives per leaf by the thesis's node counts: (95685 / 21029) to (50410 / 5751).
    EXPECT_THAT(text, HasSubstr("4.55 to 8.77 times as many"));
}

TEST(ThesisComparison, SolvesForTheChargeThatWouldExplainTheThesis) {
    // V = 30 of 50, T = 398.1 of 10: (2.734 * 50 - 30) / (398.1 - 2.734 * 10) = 0.288.
    EXPECT_THAT(comparison_of(make_results()),
                HasSubstr("(2.73 times) would need a test to be charged 0.288 of a step"));
    json results = make_results();
    for (json& detail : results["scenes"][0]["details"]) {
        detail["expected_primitive_tests"] = 10.0;  // no charge makes the ratio that great
    }
    EXPECT_THAT(comparison_of(results), Not(HasSubstr("would need a test")));
    results["scenes"][0].erase("details");
    EXPECT_THAT(comparison_of(results), Not(HasSubstr("would need a test")));
}

TEST(ThesisComparison, ComparesOnlyWhatBothHave) {
    EXPECT_THAT(comparison_of(make_results({.percents = {100, 7, 0.5}})),
                HasSubstr("share no percentage"));
    const std::string half = comparison_of(make_results({.percents = {100, 50}}));
    EXPECT_EQ(half.find("At 50"), half.rfind("At 50"));
    json results = make_results({.percents = {50, 10}});
    for (json& row : results["scenes"][0]["rows"]) {
        row["relative_cost"] = nullptr;
    }
    EXPECT_THAT(comparison_of(results), HasSubstr("no 100&nbsp;% trees"));
}

}  // namespace
}  // namespace coppice::report
