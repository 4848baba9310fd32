#include "coppice/json/build_report.h"

#include "coppice/json/build_options.h"
#include "coppice/json/tree_statistics.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace coppice::test {
namespace {

constexpr StageReports example_stages{.sample = {0.5, 1.0, 500},
                                      .build = {1.0, 2.0, 7},
                                      .empty = {0.25, 0.25, 7},
                                      .refill = {2.0, 3.0, 1200},
                                      .refine = {4.0, 8.0, 1500}};

TEST(BuildReport, IsSerializedWithAllFields) {
    BuildReport report;
    report.options = KdOptions{.sample = {.rate = 0.5}};
    report.sample = {.rate = 0.5, .seed = 3};
    report.notes = {{"sample.seed", "for no reason"}};
    report.method = "sampled";
    report.primitive_count = 1000;
    report.sample_count = 500;
    report.stages = example_stages;
    report.tree_bytes = 8000;
    report.peak_bytes = 64000;
    report.estimate = {1600.0, 8100.0, 70000.0, 7.5};
    report.statistics.node_count = 7;
    const nlohmann::json json = report;
    EXPECT_EQ(json.size(), 13U);
    EXPECT_EQ(json.at("options"), nlohmann::json(report.options));
    EXPECT_EQ(json.at("method"), "sampled");
    EXPECT_EQ(json.at("sample"), nlohmann::json(report.sample));
    EXPECT_EQ(json.at("notes"),
              nlohmann::json::array({{{"option", "sample.seed"}, {"reason", "for no reason"}}}));
    EXPECT_EQ(json.at("primitive_count"), 1000);
    EXPECT_EQ(json.at("sample_count"), 500);
    const auto stage = [](double wall, double cpu, std::uint64_t items) {
        return nlohmann::json{{"wall_seconds", wall}, {"cpu_seconds", cpu}, {"items", items}};
    };
    EXPECT_EQ(json.at("stages"),
              nlohmann::json({{"sample", stage(0.5, 1.0, 500)},
                              {"build", stage(1.0, 2.0, 7)},
                              {"empty", stage(0.25, 0.25, 7)},
                              {"refill", stage(2.0, 3.0, 1200)},
                              {"refine", stage(4.0, 8.0, 1500)},
                              {"total", {{"wall_seconds", 7.75}, {"cpu_seconds", 14.25}}}}));
    EXPECT_EQ(json.at("tree_bytes"), 8000);
    EXPECT_EQ(json.at("peak_bytes"), 64000);
    EXPECT_EQ(json.at("estimate"), nlohmann::json({{"references", 1600.0},
                                                   {"bytes", 8100.0},
                                                   {"peak_bytes", 70000.0},
                                                   {"seconds", 7.5}}));
    EXPECT_EQ(json.at("statistics"), nlohmann::json(report.statistics));
}

TEST(BuildReport, HasNullForNoEstimate) {
    EXPECT_TRUE(nlohmann::json(BuildReport{}).at("estimate").is_null());
}

}  // namespace
}  // namespace coppice::test
