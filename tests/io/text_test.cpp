#include "io/text.h"

#include "coppice/base/error.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <charconv>
#include <cmath>
#include <cstdlib>
#include <random>
#include <string>

namespace coppice {
namespace {

std::uint32_t bits(float value) {
    return std::bit_cast<std::uint32_t>(value);
}

/// parse_float of a word that spells a number.
float parsed(const std::string& word) {
    const std::optional<float> value = parse_float(word);
    EXPECT_TRUE(value) << word;
    return value.value_or(12345.0F);
}

TEST(ParseFloat, AgreesWithStrtofOnNumbersOfAllLengths) {
    std::mt19937 random(3);
    for (int i = 0; i < 100'000; ++i) {
        const auto value = std::bit_cast<float>(static_cast<std::uint32_t>(random()));
        if (!std::isfinite(value)) {
            continue;
        }
        for (const std::string& word : {fmt::format("{}", value), fmt::format("{:.17g}", value),
                                        fmt::format("{:.3e}", value), fmt::format("{:f}", value)}) {
            ASSERT_EQ(bits(parsed(word)), bits(std::strtof(word.c_str(), nullptr))) << word;
        }
    }
}

TEST(ParseFloat, RoundsDecimalsNextToTheMiddleOfTwoFloats) {
    std::mt19937 random(4);
    for (int i = 0; i < 100'000; ++i) {
        const float low = static_cast<float>(random() % 1'000'000) / 1000.0F + 0.001F;
        const double middle = (static_cast<double>(low) + std::nextafterf(low, 1e9F)) / 2;
        const std::string word = fmt::format("{:.40f}", middle);  // all its digits
        const std::string above = word + "1";
        ASSERT_EQ(bits(parsed(above)), bits(std::nextafterf(low, 1e9F))) << above;
        ASSERT_EQ(bits(parsed(word)), bits(std::strtof(word.c_str(), nullptr))) << word;
    }
}

TEST(ParseFloat, HandlesTheEdgesOfItsRange) {
    EXPECT_EQ(parsed("3.4028235e38"), 3.4028235e38F);
    EXPECT_TRUE(std::isinf(parsed("3.4028236e38")));
    EXPECT_TRUE(std::isinf(parsed("1e400")));
    EXPECT_TRUE(std::isinf(parsed("-inf")));
    EXPECT_TRUE(std::isnan(parsed("nan")));
    EXPECT_EQ(parsed("1e-45"), 1e-45F);
    EXPECT_EQ(bits(parsed("1e-46")), bits(0.0F));
    EXPECT_EQ(bits(parsed("-1e-400")), bits(-0.0F));
    EXPECT_EQ(bits(parsed("-0")), bits(-0.0F));
    EXPECT_EQ(parsed("+1.5"), 1.5F);
    EXPECT_EQ(parsed("1."), 1.0F);
    EXPECT_EQ(parsed(".5"), 0.5F);
    EXPECT_EQ(parsed("0." + std::string(400, '0') + "1e401"), 1.0F);
}

TEST(ParseFloat, TakesWholeWordsOnly) {
    for (const char* const word :
         {"", "+", "-", "+-1", "++1", "1x", "1 ", " 1", "1e", "0x1", "."}) {
        EXPECT_FALSE(parse_float(word)) << word;
    }
}

TEST(TakeWord, SplitsAtBlanksAndTabs) {
    std::string_view rest = " \tone  two\t";
    EXPECT_EQ(take_word(rest), "one");
    EXPECT_EQ(take_word(rest), "two");
    EXPECT_EQ(take_word(rest), "");
    EXPECT_EQ(take_word(rest), "");
}

TEST(InQuotes, GivesOneShortLine) {
    EXPECT_EQ(in_quotes("a\tb\n\x7f"),
              "'a?b?"
              "?'");
    EXPECT_EQ(in_quotes("\xC3\xA9"), "'\xC3\xA9'");
}

}  // namespace
}  // namespace coppice
