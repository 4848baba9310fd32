#include "report/inspector_data.h"

#include "report/base64.h"
#include "report/exhibits_fixture.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <cmath>
#include <string>
#include <vector>

namespace coppice::report {
namespace {

using nlohmann::json;

// Base64 text as bytes, by the alphabet of RFC 4648.
std::vector<unsigned> bytes_of(const json& text) {
    const std::string alphabet = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::vector<unsigned> bytes;
    unsigned bits = 0;
    int bit_count = 0;
    for (const char letter : text.get<std::string>()) {
        if (letter == '=') break;
        bits = bits << 6U | static_cast<unsigned>(alphabet.find(letter));
        bit_count += 6;
        if (bit_count < 8) continue;
        bit_count -= 8;
        bytes.push_back(bits >> static_cast<unsigned>(bit_count) & 255U);
    }
    return bytes;
}

std::vector<unsigned> words_of(const json& text) {
    const std::vector<unsigned> bytes = bytes_of(text);
    std::vector<unsigned> words;
    for (std::size_t i = 0; i + 1 < bytes.size(); i += 2) {
        words.push_back(bytes[i] | bytes[i + 1] << 8U);
    }
    return words;
}

TEST(Base64, IsThatOfRfc4648) {
    EXPECT_EQ(base64(""), "");
    EXPECT_EQ(base64("f"), "Zg==");
    EXPECT_EQ(base64("fo"), "Zm8=");
    EXPECT_EQ(base64("foo"), "Zm9v");
    EXPECT_EQ(base64("foobar"), "Zm9vYmFy");
    EXPECT_EQ(base64("\xff\xfe\xfd"), "//79");
}

TEST(InspectorData, JoinsPositionsAndPointsTrianglesAtThem) {
    const json data = inspector_data(*test::make_exhibits().inspector);
    // A flat axis is 0 everywhere.
    EXPECT_EQ(words_of(data["positions"]),
              (std::vector<unsigned>{0, 0, 0, 65535, 0, 0, 65535, 65535, 0, 0, 65535, 0}));
    EXPECT_EQ(data["index_count"], 6);
    // 0 1 2 0 2 3 as steps 0 1 1 -2 2 1, in zigzag.
    EXPECT_EQ(bytes_of(data["indices"]), (std::vector<unsigned>{0, 2, 2, 3, 4, 2}));
    EXPECT_FALSE(data.contains("shades"));
}

TEST(InspectorData, TakesSevenBitsOfAnIndexAByte) {
    Inspector inspector;
    inspector.bounds = {{0, 0, 0}, {999, 1, 1}};
    for (int i = 0; i < 1000; ++i) {
        inspector.outline.positions.push_back({static_cast<float>(i), 0, 0});
    }
    inspector.outline.triangles = {{300, 0, 999}};
    // 600, -300 -> 599, 1998: low bits first.
    EXPECT_EQ(bytes_of(inspector_data(inspector)["indices"]),
              (std::vector<unsigned>{600 % 128 + 128, 600 / 128, 599 % 128 + 128, 599 / 128,
                                     1998 % 128 + 128, 1998 / 128}));
}

TEST(InspectorData, KeepsPointsWithTheirShades) {
    Inspector inspector;
    inspector.bounds = {{0, 0, 0}, {2, 2, 2}};
    inspector.outline = {{{1, 0, 2}, {1, 0, 2}}, {}, {7, 255}};
    const json data = inspector_data(inspector);
    EXPECT_EQ(words_of(data["positions"]),
              (std::vector<unsigned>{32768, 0, 65535, 32768, 0, 65535}));
    EXPECT_EQ(bytes_of(data["shades"]), (std::vector<unsigned>{7, 255}));
    EXPECT_FALSE(data.contains("indices"));
}

TEST(InspectorData, HasTheCellsOfEveryLevel) {
    const json trees = inspector_data(*test::make_exhibits().inspector)["trees"];
    ASSERT_EQ(trees.size(), 2U);
    EXPECT_EQ(trees[0]["levels"], json::parse("[[1, 0, 1], [2, 1, 2]]"));
    EXPECT_EQ(words_of(trees[0]["boxes"]),
              (std::vector<unsigned>{0, 0, 0, 65535, 65535, 0, 0, 0, 0, 32768, 65535, 0,  //
                                     32768, 0, 0, 65535, 65535, 0}));
    // log2(1/4) = -2 of 40; none is 0.
    EXPECT_EQ(words_of(trees[0]["shares"]), (std::vector<unsigned>{65535, 62258, 0}));
    const std::vector<unsigned> counts = words_of(trees[0]["counts"]);
    EXPECT_EQ(counts[2], 0U);
    EXPECT_EQ(std::lround(std::exp2(counts[1] * 40.0 / 65535.0) - 1.0), 2);
}

}  // namespace
}  // namespace coppice::report
