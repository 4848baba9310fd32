#include "text/json_text.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace coppice::lab {

namespace {

using Json = nlohmann::ordered_json;

TEST(JsonText, IsValidUtf8WhateverTheNamesAre) {
    const Json document{{"file", "a\xff.ply"}, {"count", 2}};
    EXPECT_EQ(json_text(document), "{\n  \"file\": \"a\xEF\xBF\xBD.ply\",\n  \"count\": 2\n}\n");
    EXPECT_EQ(json_line(document), "{\"file\":\"a\xEF\xBF\xBD.ply\",\"count\":2}");
    EXPECT_EQ(json_ascii_line(document), "{\"file\":\"a\\ufffd.ply\",\"count\":2}");
}

TEST(JsonText, IsReadBackWithoutWhatJsonCannotHold) {
    const Json written = as_written(Json{{"name", "\xff"}, {"cost", std::nan("")}});
    EXPECT_EQ(written["name"], "\xEF\xBF\xBD");
    EXPECT_TRUE(written["cost"].is_null());
}

TEST(JsonText, NumbersAreNullUnlessFinite) {
    EXPECT_EQ(number_json(0.5), Json(0.5));
    EXPECT_TRUE(number_json(std::numeric_limits<double>::infinity()).is_null());
    EXPECT_TRUE(number_json(std::numeric_limits<float>::infinity()).is_null());
    EXPECT_TRUE(number_json(std::optional<double>()).is_null());
    EXPECT_TRUE(number_json(std::optional(std::nan(""))).is_null());
    EXPECT_EQ(vector_json({1.0F, -2.0F, 0.5F}), Json({1.0, -2.0, 0.5}));
}

}  // namespace

}  // namespace coppice::lab
