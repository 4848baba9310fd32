#include "rows/results.h"

#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include <limits>

namespace coppice::lab {

namespace {

ResultRow example_row() {
    ResultRow row;
    row.scene = "dragon";
    row.primitives = "triangles";
    row.protocol = "scaled";
    row.sample_percent = 0.1;
    row.seed = 3;
    row.report.primitive_count = 871414;
    row.report.sample_count = 871;
    row.report.stages = {{0.001}, {0.25}, {1e-7}, {0.0625}, {0.0}};
    row.report.statistics.node_count = 101;
    row.report.statistics.inner_count = 50;
    row.report.statistics.leaf_count = 51;
    row.report.statistics.single_primitive_leaf_count = 7;
    row.report.statistics.empty_leaf_count = 9;
    row.report.statistics.reference_count = 5'000'000'000;
    row.report.statistics.max_level = 12;
    row.report.statistics.mean_leaf_size = 1.0 / 3.0;
    row.report.statistics.sah_cost = 88.5;
    row.relative_cost = 1.125;
    return row;
}

std::string csv_of(const ResultRow& row) {
    SceneResult scene;
    scene.rows = {row};
    return csv_text({&scene, 1});
}

TEST(Results, CsvHeaderIsTheAgreedOne) {
    EXPECT_EQ(csv_header(),
              "scene,primitives,protocol,split,sampler,sample_percent,seed,primitive_count,"
              "sample_count,node_count,inner_count,leaf_count,single_primitive_leaf_count,"
              "empty_leaf_count,reference_count,max_level,mean_leaf_size,sample_seconds,"
              "build_seconds,empty_seconds,refill_seconds,refine_seconds,total_seconds,sah_cost,"
              "relative_cost");
}

TEST(Results, CsvLine) {
    EXPECT_EQ(csv_of(example_row()),
              csv_header() +
                  "\ndragon,triangles,scaled,sah,uniform,0.1,3,871414,871,101,50,51,7,9,5000000000,"
                  "12,0.3333333333333333,0.001000,0.250000,0.000000,0.062500,0.000000,0.313500,"
                  "88.5,1.125\n");
}

TEST(Results, CsvWholePercentsArePlain) {
    ResultRow row = example_row();
    row.sample_percent = 50.0;
    EXPECT_THAT(csv_of(row), testing::HasSubstr(",uniform,50,3,"));
}

TEST(Results, CsvQuotesAsRfc4180) {
    ResultRow row = example_row();
    row.scene = "a \"b\", c";
    EXPECT_THAT(csv_of(row), testing::HasSubstr("\n\"a \"\"b\"\", c\",triangles,"));
    row.scene = "two\nlines";
    EXPECT_THAT(csv_of(row), testing::HasSubstr("\n\"two\nlines\",triangles,"));
}

TEST(Results, CsvOfNothingIsTheHeader) {
    EXPECT_EQ(csv_text({}), csv_header() + "\n");
}

TEST(Results, NumbersThatAreNotFiniteAreEmptyAndNull) {
    ResultRow row = example_row();
    row.relative_cost = std::numeric_limits<double>::quiet_NaN();
    row.report.statistics.sah_cost = std::numeric_limits<double>::infinity();
    EXPECT_THAT(csv_of(row), testing::EndsWith(",0.313500,,\n"));
    EXPECT_TRUE(row_json(row)["relative_cost"].is_null());
    EXPECT_TRUE(row_json(row)["sah_cost"].is_null());
}

TEST(Results, JsonRowHasTheColumnsInOrder) {
    std::string keys;
    const nlohmann::ordered_json row = row_json(example_row());
    for (const auto& [key, value] : row.items()) {
        keys += (keys.empty() ? "" : ",") + key;
    }
    EXPECT_EQ(keys, csv_header());
}

TEST(Results, JsonRowHasTheValues) {
    const auto row = row_json(example_row());
    EXPECT_EQ(row["scene"], "dragon");
    EXPECT_EQ(row["sample_percent"], 0.1);
    EXPECT_EQ(row["reference_count"], 5'000'000'000);
    EXPECT_EQ(row["total_seconds"], 0.3135);
    EXPECT_EQ(row["empty_seconds"], 0.0);  // rounded to the microsecond, as in the CSV
    EXPECT_EQ(row["sah_cost"], 88.5);
}

}  // namespace

}  // namespace coppice::lab
