#include "report/tables.h"

#include "report/results_fixture.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

namespace coppice::report {
namespace {

using nlohmann::json;
using test::make_results;
using testing::HasSubstr;
using testing::Not;

std::size_t count(const std::string& text, const std::string& part) {
    std::size_t found = 0;
    for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) {
        ++found;
    }
    return found;
}

std::string rows_of(const json& results) {
    return make_rows_table(results["scenes"][0], collect_series(results).front());
}

TEST(RowsTable, HasARowForEveryTreeOfTheKindAndACellForEveryColumn) {
    const std::string table = rows_of(make_results({.seeds = {1, 2}}));
    EXPECT_EQ(count(table, "<tr"), 2U + 3U * 4U * 2U);
    const std::size_t headings = count(table, "<th scope=\"col\"");
    EXPECT_EQ(count(table, "<td") + count(table, "<th scope=\"row\""), headings * 3U * 4U * 2U);
    EXPECT_THAT(table, HasSubstr(">seed</th>"));
}

TEST(RowsTable, SaysConstantsOnceInItsCaption) {
    const std::string table = rows_of(make_results());
    EXPECT_THAT(table, HasSubstr("primitives: 437,645; split: sah; sampler: uniform; seed: 1."));
    EXPECT_THAT(table, Not(HasSubstr(">seed</th>")));
    EXPECT_THAT(table, HasSubstr("Time (ms)"));
    EXPECT_THAT(table, HasSubstr("<td>2,000</td>"));  // 2 s of building
}

TEST(RowsTable, MarksWhatIsRecommendedAndWhatIsMissing) {
    json results = make_results();
    results["scenes"][0]["rows"][0]["relative_cost"] = nullptr;
    const std::string table = rows_of(results);
    EXPECT_EQ(count(table, "50\u00a0% ◎"), 3U);
    EXPECT_EQ(count(table, "<td>–</td>"), 1U);
}

TEST(RecommendationTable, PutsTheRuleBesideTheThesissHalf) {
    json results = make_results();
    for (json& row : results["scenes"][0]["recommended"]) {
        row["sample_percent"] = 10;
    }
    const std::string table =
        make_recommendation_table(results["scenes"][0], collect_series(results));
    EXPECT_EQ(count(table, "<tr>"), 2U + 6U);  // no cell spans rows: the table can be sorted
    EXPECT_EQ(count(table.substr(table.find("<tbody>")), "rowspan"), 0U);
    EXPECT_EQ(count(table, "<td class=\"key\">10\u00a0%</td>"), 6U);
    EXPECT_THAT(table, HasSubstr("<td>1.74</td><td>0.510</td>"));  // 2^0.8; 1.041 s of 2.041 s
}

TEST(ThesisTable, HasThePercentagesOfBoth) {
    const json results = make_results({.percents = {100, 50, 7}});
    const std::string table = make_thesis_table(collect_series(results).front(), thesis_tables());
    EXPECT_EQ(count(table, "<th scope=\"row\">"), 12U);  // the thesis's eleven and 7 %
    EXPECT_EQ(count(table, "<td>"), 12U * 14U);
    EXPECT_THAT(table, HasSubstr("<th scope=\"row\">50\u00a0%</th><td>1.21</td><td>1.07</td>"
                                 "<td>1.04</td><td>1.07</td><td>1.74</td>"));
    EXPECT_THAT(table, HasSubstr("<th scope=\"row\">7\u00a0%</th><td>–</td>"));
}

TEST(FieldsTable, FlattensNestedObjectsAndSpellsUnits) {
    const std::string table = make_fields_table({{"memory_bytes", 16'777'216'000},
                                                 {"load_seconds", 0.412},
                                                 {"polygons", {{"count", 1200}, {"first", {3, 4}}}},
                                                 {"empty_bonus", 0.5},
                                                 {"warnings", json::array()},
                                                 {"note", nullptr},
                                                 {"cpu", "<b>"}},
                                                "Fields");
    EXPECT_THAT(table, HasSubstr("<th scope=\"row\">memory</th><td>15.6 GiB</td>"));
    EXPECT_THAT(table, HasSubstr("<th scope=\"row\">load</th><td>412 ms</td>"));
    EXPECT_THAT(table, HasSubstr("<th scope=\"row\">polygons count</th><td>1,200</td>"));
    EXPECT_THAT(table, HasSubstr("<th scope=\"row\">polygons first</th><td>3, 4</td>"));
    EXPECT_THAT(table, HasSubstr("<td>0.5</td>"));
    EXPECT_THAT(table, HasSubstr("<th scope=\"row\">warnings</th><td>none</td>"));
    EXPECT_THAT(table, HasSubstr("<td>not recorded</td>"));
    EXPECT_THAT(table, HasSubstr("<td>&lt;b&gt;</td>"));
    EXPECT_THAT(make_fields_table(nullptr, "Nothing"), HasSubstr("not recorded"));
}

}  // namespace
}  // namespace coppice::report
