#include "coppice/build/build_report.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace coppice::test {
namespace {

TEST(StageSeconds, AddUp) {
    EXPECT_EQ(StageSeconds{}.total(), 0.0);
    const StageSeconds seconds{.sample = 1, .build = 2, .empty = 4, .refill = 8, .refine = 16};
    EXPECT_EQ(seconds.total(), 31.0);
}

TEST(BuildReport, IsSerializedWithAllFields) {
    const BuildReport report{
        .options = {.sample = {.rate = 0.5}},
        .primitive_count = 1000,
        .sample_count = 500,
        .seconds = {.sample = 0.5, .build = 1, .empty = 0.25, .refill = 2, .refine = 4},
        .statistics = {.node_count = 7}};
    const nlohmann::json json = report;
    EXPECT_EQ(json.size(), 5U);
    EXPECT_EQ(json.at("options"), nlohmann::json(report.options));
    EXPECT_EQ(json.at("primitive_count"), 1000);
    EXPECT_EQ(json.at("sample_count"), 500);
    EXPECT_EQ(json.at("seconds"), nlohmann::json({{"sample", 0.5},
                                                  {"build", 1.0},
                                                  {"empty", 0.25},
                                                  {"refill", 2.0},
                                                  {"refine", 4.0},
                                                  {"total", 7.75}}));
    EXPECT_EQ(json.at("statistics"), nlohmann::json(report.statistics));
}

}  // namespace
}  // namespace coppice::test
