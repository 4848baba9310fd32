#include "report/make_report.h"

#include "coppice/base/error.h"

#include "report/assets.h"
#include "report/exhibits_fixture.h"
#include "report/results_fixture.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <regex>
#include <set>
#include <string>
#include <string_view>
#include <vector>

namespace coppice::report {
namespace {

using nlohmann::json;
using test::Experiment;
using test::make_results;

// Pages are too long for gtest to print them.
bool contains(const std::string& page, std::string_view text) {
    return page.find(text) != std::string::npos;
}

// The page's own text: without what stands inside scripts and styles.
std::string markup_of(const std::string& page) {
    std::string markup;
    std::size_t at = 0;
    while (at < page.size()) {
        const std::size_t script = page.find("<script", at);
        const std::size_t style = page.find("<style", at);
        const std::size_t open = std::min({script, style, page.size()});
        const std::size_t inside = open < page.size() ? page.find('>', open) + 1 : page.size();
        markup += page.substr(at, inside - at);
        at = page.find(open == script ? "</script>" : "</style>", inside);
    }
    return markup;
}

// The specifications of the page's charts by their ids.
std::map<std::string, json> charts_of(const std::string& page) {
    std::map<std::string, json> charts;
    const std::string open = "<script type=\"application/json\" class=\"chart\" id=\"";
    for (std::size_t at = page.find(open); at != std::string::npos; at = page.find(open, at)) {
        at += open.size();
        const std::string id = page.substr(at, page.find('"', at) - at);
        const std::size_t begin = page.find('>', at) + 1;
        const std::size_t end = page.find("</script>", begin);
        const bool is_new = charts.emplace(id, json::parse(page.substr(begin, end - begin))).second;
        EXPECT_TRUE(is_new) << "two charts with the id " << id;
    }
    return charts;
}

// The first tag that is closed in the wrong place or not at all, or "".
std::string find_unbalanced_tag(const std::string& markup) {
    const std::set<std::string> has_no_end{"meta", "link", "br", "img", "input", "!doctype"};
    std::vector<std::string> open;
    const std::regex tag("<(/?)([!a-z0-9]+)[^>]*>");
    for (std::sregex_iterator at(markup.begin(), markup.end(), tag), end; at != end; ++at) {
        const std::string name = (*at)[2];
        if (has_no_end.contains(name)) continue;
        if ((*at)[1].length() == 0) {
            open.push_back(name);
        } else if (open.empty() || open.back() != name) {
            return "</" + name + ">";
        } else {
            open.pop_back();
        }
    }
    return open.empty() ? "" : "<" + open.back() + ">";
}

TEST(MakeReport, LoadsNothingFromAnywhere) {
    const std::string page = make_report(make_results());
    const std::string markup = markup_of(page);
    EXPECT_TRUE(contains(markup, "content=\"default-src 'none';"));
    EXPECT_FALSE(contains(markup, "src="));
    EXPECT_FALSE(contains(markup, "http:"));
    EXPECT_FALSE(contains(markup, "https:"));
    for (std::size_t at = markup.find("href="); at != std::string::npos;
         at = markup.find("href=", at + 1)) {
        EXPECT_TRUE(markup.substr(at).starts_with("href=\"#") ||
                    markup.substr(at).starts_with("href=\"data:,\""))
            << markup.substr(at, 60);
    }
    const std::string css(embedded_assets().page_css);
    EXPECT_FALSE(contains(css, "url("));
    EXPECT_FALSE(contains(css, "@import"));
    EXPECT_FALSE(contains(page, "sourceMappingURL"));
    EXPECT_LT(page.size(), 8'000'000U);
}

TEST(MakeReport, CarriesTheChartLibrariesWhole) {
    const Assets& assets = embedded_assets();
    const std::string page = make_report(make_results());
    EXPECT_TRUE(contains(page, std::string(assets.vega.substr(0, 2000))));
    EXPECT_TRUE(contains(page, std::string(assets.vega_lite.substr(0, 2000))));
    EXPECT_TRUE(contains(page, std::string(assets.vega_embed.substr(0, 2000))));
    for (const std::string_view script :
         {assets.vega, assets.vega_lite, assets.vega_embed, assets.page_js, assets.inspector_js}) {
        EXPECT_GT(script.size(), 1000U);
        EXPECT_EQ(script.find("<!--"), std::string_view::npos);  // would hide the page's end
    }
    EXPECT_TRUE(contains(page, "Mike Bostock"));  // licences go where the code goes
}

TEST(MakeReport, HasAllChartsOfEverySceneAndKind) {
    const auto charts = charts_of(make_report(make_results({.scenes = {"dragon", "kitchen"}})));
    for (const char* scene : {"dragon", "kitchen"}) {
        for (const char* kind : {"points", "triangles"}) {
            for (const char* name :
                 {"cost-time", "cost", "time", "nodes", "levels", "leaf-size", "cost-time-linear",
                  "stages-fixed", "stages-scaled", "stages-grown", "inner-visits", "leaf-visits",
                  "tests", "cost-share", "leaf-levels"}) {
                const std::string id =
                    std::string(scene).append("-").append(kind).append("-").append(name);
                ASSERT_TRUE(charts.contains(id)) << id;
                EXPECT_FALSE(charts.at(id)["data"]["values"].empty()) << id;
                EXPECT_FALSE(charts.at(id)["description"].empty()) << id;
            }
        }
        EXPECT_TRUE(charts.contains(std::string(scene) + "-points-thesis-cost"));
        EXPECT_TRUE(charts.contains(std::string(scene) + "-points-thesis-time"));
    }
    EXPECT_EQ(charts.size(), 2U * (2U * 16U + 2U));
}

TEST(MakeReport, EveryChartHasAPlaceOnThePage) {
    const std::string page = make_report(make_results());
    for (const auto& [id, chart] : charts_of(page)) {
        EXPECT_TRUE(contains(page, "data-chart=\"" + id + "\""));
    }
}

TEST(MakeReport, EscapesEveryStringOfTheResults) {
    json results = make_results({.scenes = {test::evil_name},
                                 .kinds = {"points", test::evil_name},
                                 .protocols = {"fixed", test::evil_name}});
    for (const char* key : {"coppice", "created", "git_revision", "compiler", "build_type"}) {
        results[key] = test::evil_name;
    }
    results["machine"]["cpu"] = test::evil_name;
    results["options"]["split"] = test::evil_name;
    results["options"][test::evil_name] = {test::evil_name};
    results["scenes"][0]["file"] = test::evil_name;
    results["scenes"][0]["load_report"] = {{test::evil_name, test::evil_name}};
    for (json& row : results["scenes"][0]["rows"]) {
        row["sampler"] = test::evil_name;
    }
    for (json& row : results["scenes"][0]["recommended"]) {
        row["rule"] = test::evil_name;
        row["source"] = test::evil_name;
    }
    const std::string page = make_report(results);
    EXPECT_FALSE(contains(page, "<b onmouseover"));
    EXPECT_FALSE(contains(markup_of(page), "\"alert("));
    EXPECT_EQ(find_unbalanced_tag(markup_of(page)), "");
    // The charts and the data are still what they were.
    EXPECT_EQ(charts_of(page).size(), 2U * 15U + 2U);
    const std::string open = "<script type=\"application/json\" id=\"results\">";
    const std::size_t begin = page.find(open) + open.size();
    EXPECT_EQ(json::parse(page.substr(begin, page.find("</script>", begin) - begin)), results);
}

TEST(MakeReport, TellsMachineOptionsAndRevision) {
    const std::string page = make_report(make_results());
    for (const char* text :
         {"abc1234", "GCC 12.2.0 -O3", "a processor", "15.6 GiB", "2026-11-22T05:40:00Z",
          "<th scope=\"row\">max depth</th><td>50</td>", "eb = 0.5", "412 ms",
          "<td>-1, -2, -3</td>", "Satopää", "Tsiompikas"}) {
        EXPECT_TRUE(contains(page, text)) << text;
    }
}

struct Case {
    const char* name;
    Experiment experiment;
};

class MakeReportFrom : public testing::TestWithParam<Case> {};

TEST_P(MakeReportFrom, IsAWholePage) {
    const std::string page = make_report(make_results(GetParam().experiment));
    EXPECT_EQ(find_unbalanced_tag(markup_of(page)), "");
    const auto charts = charts_of(page);
    EXPECT_EQ(charts.empty(), GetParam().experiment.scenes.empty());
    for (const auto& [id, chart] : charts) {
        const std::string text = chart.dump();
        EXPECT_FALSE(contains(text, "null,null")) << id;  // what is not finite becomes null
        EXPECT_FALSE(contains(markup_of(page), "nan"));
    }
}

INSTANTIATE_TEST_SUITE_P(
    AnyResults, MakeReportFrom,
    testing::Values(
        Case{"without_scenes", {.scenes = {}}}, Case{"without_100_percent", {.percents = {50, 10}}},
        Case{"one_row", {.kinds = {"triangles"}, .protocols = {"grown"}, .percents = {100}}},
        Case{"one_rate", {.percents = {10}}}, Case{"one_protocol", {.protocols = {"scaled"}}},
        Case{"unknown_protocol", {.protocols = {"new"}}},
        Case{"several_seeds", {.seeds = {1, 2, 3}}},
        Case{"several_scenes", {.scenes = {"a", "b", "c"}}},
        Case{"tiny_rates", {.percents = {100, 1, 0.1, 0.01}}},
        Case{"rates_unlike_the_thesis", {.percents = {100, 7, 0.3}}}),
    [](const testing::TestParamInfo<Case>& test) { return std::string(test.param.name); });

TEST(MakeReport, TakesTimesOfZero) {
    json results = make_results();
    for (json& row : results["scenes"][0]["rows"]) {
        for (auto& [key, value] : row.items()) {
            if (key.ends_with("_seconds")) value = 0.0;
        }
    }
    const std::string page = make_report(results);
    EXPECT_EQ(charts_of(page).size(), 34U);
    EXPECT_FALSE(contains(markup_of(page), "nan"));
    EXPECT_FALSE(contains(markup_of(page), "inf<"));
}

TEST(MakeReport, TakesResultsThatSayLittle) {
    const std::string page = make_report(json::parse(R"({"scenes": [
        {"scene": "a", "rows": [{"primitives": "points", "protocol": "fixed",
                                 "sample_percent": 10, "sah_cost": 5}]},
        {"rows": [3, "x", null], "details": 4, "recommended": [1]}, {}]})"));
    EXPECT_EQ(find_unbalanced_tag(markup_of(page)), "");
    EXPECT_TRUE(charts_of(page).contains("a-points-cost"));
    EXPECT_TRUE(contains(page, "not recorded"));
}

TEST(MakeReport, ShowsExhibitsInsideThePage) {
    const std::vector<SceneExhibits> exhibits{test::make_exhibits()};
    const std::string page = make_report(make_results({.scenes = {"a", "b"}}), exhibits);
    const std::string markup = markup_of(page);
    EXPECT_EQ(find_unbalanced_tag(markup), "");
    std::size_t image_count = 0;
    for (std::size_t at = markup.find("src="); at != std::string::npos;
         at = markup.find("src=", at + 1)) {
        EXPECT_TRUE(markup.substr(at).starts_with("src=\"data:image/png;base64,")) << at;
        ++image_count;
    }
    EXPECT_EQ(image_count, 4U);
    // The picture stands on the first screen, before the first chart.
    EXPECT_LT(markup.find("src="), markup.find("class=\"plot\""));
    for (const char* text :
         {"data-inspector=\"scene-1-inspector-data\"", "coppice render --eye=1,2,3",
          "takes 20.0 steps on average in the full tree and 25.0 in the other, 1.25 times"}) {
        EXPECT_TRUE(contains(markup, text)) << text;
    }
    EXPECT_TRUE(contains(page, std::string(embedded_assets().inspector_js.substr(0, 2000))));
}

TEST(MakeReport, SaysWhichExhibitsAreMissing) {
    std::vector<SceneExhibits> exhibits(1);
    exhibits.front().missing = "Not <b> today.";
    const std::string page = make_report(make_results(), exhibits);
    EXPECT_TRUE(contains(page, "Not &lt;b&gt; today."));
    EXPECT_FALSE(contains(page, std::string(embedded_assets().inspector_js.substr(0, 2000))));
    EXPECT_FALSE(contains(markup_of(page), "data-inspector"));
}

TEST(MakeReport, RefusesWhatIsNoResultsDocument) {
    EXPECT_THROW((void)make_report(json::array()), Error);
    EXPECT_THROW((void)make_report({{"scenes", 3}}), Error);
}

}  // namespace
}  // namespace coppice::report
