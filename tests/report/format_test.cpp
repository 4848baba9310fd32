#include "report/format.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <limits>
#include <string>
#include <vector>

namespace coppice::report {
namespace {

TEST(EscapeHtml, LeavesNoCharacterThatHtmlReads) {
    EXPECT_EQ(escape_html("<b a='1' c=\"2\">&amp;"),
              "&lt;b a=&#39;1&#39; c=&quot;2&quot;&gt;&amp;amp;");
    EXPECT_EQ(escape_html("Ωmega 5"), "Ωmega 5");
}

TEST(ScriptJson, HoldsNoTagAndReadsBackTheSame) {
    const nlohmann::json json{{"</script><!--", {1, 0.5, "<b>"}}};
    const std::string text = script_json(json);
    EXPECT_EQ(text.find('<'), std::string::npos);
    EXPECT_EQ(nlohmann::json::parse(text), json);
}

TEST(ScriptJson, SurvivesBytesThatAreNotUtf8) {
    const std::string text = script_json({{"scene", "a\xff"}});
    EXPECT_EQ(nlohmann::json::parse(text)["scene"], "a\ufffd");
}

TEST(ScriptText, CannotEndItsElementAndPointsToNoMap) {
    EXPECT_EQ(script_text("a='</script>';b='</SCRIPT >'"), "a='<\\/script>';b='<\\/SCRIPT >'");
    EXPECT_EQ(script_text("x()\n//# sourceMappingURL=vega.min.js.map\n"), "x()\n\n");
    EXPECT_EQ(script_text("x()\n//# sourceMappingURL=vega.min.js.map"), "x()\n");
    EXPECT_EQ(script_text("a</b/.test(c)"), "a</b/.test(c)");
}

TEST(MakeSlug, KeepsLettersAndDigits) {
    EXPECT_EQ(make_slug("Kitchen (v2)"), "kitchen-v2");
    EXPECT_EQ(make_slug("..//.."), "unnamed");
    EXPECT_EQ(make_slug("Ωmega"), "mega");
}

TEST(FormatCount, SeparatesThousands) {
    EXPECT_EQ(format_count(0), "0");
    EXPECT_EQ(format_count(999), "999");
    EXPECT_EQ(format_count(1000), "1,000");
    EXPECT_EQ(format_count(5'545'806), "5,545,806");
    EXPECT_EQ(format_count(-12'345), "-12,345");
    EXPECT_EQ(format_count(21.6), "21.6");
    EXPECT_EQ(format_count(std::numeric_limits<double>::quiet_NaN()), "–");
}

TEST(FormatRatio, KeepsThreeDigitsOfAnySize) {
    EXPECT_EQ(format_ratio(0), "0");
    EXPECT_EQ(format_ratio(0.033244), "0.0332");
    EXPECT_EQ(format_ratio(0.4444), "0.444");
    EXPECT_EQ(format_ratio(1), "1.00");
    EXPECT_EQ(format_ratio(12.345), "12.3");
    EXPECT_EQ(format_ratio(47), "47.0");
    EXPECT_EQ(format_ratio(12'345.6), "12,346");
    EXPECT_EQ(format_ratio(std::numeric_limits<double>::infinity()), "–");
}

TEST(FormatPercent, ShowsWhatWasGiven) {
    EXPECT_EQ(format_percent(100), "100\u00a0%");
    EXPECT_EQ(format_percent(0.1), "0.1\u00a0%");
    EXPECT_EQ(format_percent(12.5), "12.5\u00a0%");
    EXPECT_EQ(format_share(0.02591), "2.59\u00a0%");
}

TEST(FormatTimes, NeverRoundASmallTimeToNothing) {
    EXPECT_EQ(format_milliseconds(0), "0");
    EXPECT_EQ(format_milliseconds(1e-7), "<0.001");
    EXPECT_EQ(format_milliseconds(3.1e-5), "0.031");
    EXPECT_EQ(format_milliseconds(0.0042), "4.20");
    EXPECT_EQ(format_milliseconds(1.8304), "1,830");
    EXPECT_EQ(format_duration(0), "0 s");
    EXPECT_EQ(format_duration(3.1e-5), "31.0 µs");
    EXPECT_EQ(format_duration(0.412), "412 ms");
    EXPECT_EQ(format_duration(1.834), "1.83 s");
}

TEST(FormatBytes, UsesBinaryUnits) {
    EXPECT_EQ(format_bytes(1), "1 B");
    EXPECT_EQ(format_bytes(1536), "1.50 KiB");
    EXPECT_EQ(format_bytes(16'777'216'000.0), "15.6 GiB");
}

TEST(JoinWords, ReadsLikeAList) {
    EXPECT_EQ(join_words(std::vector<std::string>{}), "");
    EXPECT_EQ(join_words(std::vector<std::string>{"a"}), "a");
    EXPECT_EQ(join_words(std::vector<std::string>{"a", "b", "c"}), "a, b and c");
}

}  // namespace
}  // namespace coppice::report
