#include "coppice/json/load_report.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <string>
#include <vector>

namespace coppice::test {
namespace {

TEST(LoadReportJson, HasEveryFieldUnderItsName) {
    LoadReport report{.file = "a.obj", .negative_index_count = 3};
    report.duplicate_vertices.add(1);
    const nlohmann::json json = report;
    std::vector<std::string> names;
    for (const auto& [name, value] : json.items()) {
        names.push_back(name);
    }
    EXPECT_THAT(names,
                testing::UnorderedElementsAre(
                    "file", "format", "file_bytes", "load_seconds", "vertex_count", "face_count",
                    "triangle_count", "polygons", "degenerate_faces", "zero_area_triangles",
                    "duplicate_triangles", "duplicate_vertices", "unused_vertices",
                    "negative_index_count", "ignored_line_count", "ignored_element_count",
                    "trailing_byte_count", "warning_count", "warnings"));
    EXPECT_EQ(json["duplicate_vertices"], nlohmann::json::parse(R"({"count": 1, "first": [1]})"));
    EXPECT_EQ(json["negative_index_count"], 3);
    EXPECT_EQ(json["file"], "a.obj");
}

}  // namespace
}  // namespace coppice::test
