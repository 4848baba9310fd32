#include "bench/bench_results.h"

#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

namespace coppice::lab {

namespace {

using testing::HasSubstr;
using testing::Not;

BenchRow make_row(const std::string& scene, const std::string& method, double build_seconds,
                  double mrays) {
    BenchRow row;
    row.scene = scene;
    row.triangles = 1000;
    row.method = method;
    row.is_peer = method.starts_with("embree");
    row.build_seconds = build_seconds;
    row.mrays = {mrays, 2.0 * mrays, std::nullopt};
    return row;
}

TEST(BenchRow, HasTheAgreedKeysInOrder) {
    std::string keys;
    const nlohmann::ordered_json row = row_json(BenchRow{});
    for (const auto& [key, value] : row.items()) {
        keys += (keys.empty() ? "" : ",") + key;
    }
    EXPECT_EQ(keys,
              "scene,triangles,method,peer,threads,build_seconds,build_seconds_first,"
              "build_cpu_seconds,bytes_per_triangle,peak_bytes_per_triangle,sah_cost,"
              "references_per_triangle,primary_mrays,shadow_mrays,diffuse_mrays,mismatches");
}

TEST(BenchRow, IsNullWhereNothingWasMeasured) {
    BenchRow row = make_row("a", "fast", 0.5, 3.0);
    row.sah_cost = 12.5;
    const auto json = row_json(row);
    EXPECT_EQ(json["primary_mrays"], 3.0);
    EXPECT_EQ(json["shadow_mrays"], 6.0);
    EXPECT_TRUE(json["diffuse_mrays"].is_null());
    EXPECT_EQ(json["sah_cost"], 12.5);
    EXPECT_TRUE(json["references_per_triangle"].is_null());
    EXPECT_EQ(json["peer"], false);
}

TEST(BenchDocument, HasMachineOptionsAndRows) {
    BenchOptions options;
    options.scenes = {"a\xff.obj"};  // not UTF-8
    options.methods = {"fast"};
    options.rays = {RayKind::diffuse, RayKind::primary};
    options.camera.eye = Vec3f{1.0F, 2.0F, 3.0F};
    BenchResult result;
    result.scenes.resize(1);
    result.scenes[0].scene = "a";
    result.scenes[0].ray_counts = {4, 0, 2};
    result.rows = {make_row("a", "fast", 1.0, 2.0)};
    const auto json = bench_document(options, result);
    EXPECT_EQ(json.size(), 3U);
    EXPECT_TRUE(json["machine"].contains("cpu"));
    EXPECT_TRUE(json["machine"].contains("git_revision"));
    EXPECT_EQ(json["options"]["rays"], nlohmann::json({"primary", "diffuse"}));
    EXPECT_EQ(json["options"]["eye"], nlohmann::json({1, 2, 3}));
    EXPECT_TRUE(json["options"]["up"].is_null());
    EXPECT_EQ(json["options"]["views"][0]["ray_counts"]["diffuse"], 2);
    EXPECT_EQ(json["rows"][0], row_json(result.rows[0]));
    EXPECT_NO_THROW(static_cast<void>(json.dump()));
}

TEST(BenchTable, HasALineForEachRow) {
    BenchScene scene;
    scene.scene = "a";
    scene.triangles = 1000;
    scene.reference = "embree-robust";
    const std::vector<BenchRow> rows{make_row("a", "fast", 0.25, 3.0),
                                     make_row("a", "embree-medium", 0.5, 2.0)};
    const std::string text = bench_table(scene, rows);
    EXPECT_THAT(text, HasSubstr("a: 1000 triangles"));
    EXPECT_THAT(text, HasSubstr("compared with embree-robust"));
    EXPECT_THAT(text, testing::ContainsRegex("\nfast +1 +0.2500 .* 3.00 +6.00 +- +0\n"));
    EXPECT_THAT(text, testing::ContainsRegex("\nembree-medium +1 +0.5000 "));
}

TEST(RatioTable, HasGeometricMeansOverTheScenes) {
    const std::vector<BenchRow> rows{
        make_row("a", "fast", 0.25, 3.0),       make_row("a", "embree-medium", 0.5, 9.0),
        make_row("a", "embree-high", 9.0, 2.0),  // 2 times faster, 1.5 times the rays
        make_row("b", "fast", 0.25, 6.0),       make_row("b", "embree-medium", 2.0, 9.0),
        make_row("b", "embree-high", 9.0, 1.0),  // 8 and 6 times
    };
    const std::string text = ratio_table(rows);
    EXPECT_THAT(text, testing::ContainsRegex("\nfast +1 a +2.00 +1.50 +1.50 +-\n"));
    EXPECT_THAT(text, testing::ContainsRegex("\nfast +1 b +8.00 +6.00 +6.00 +-\n"));
    EXPECT_THAT(text, testing::ContainsRegex("\nfast +1 geometric mean +4.00 +3.00 +3.00 +-\n"));
    EXPECT_THAT(text, Not(HasSubstr("\nembree")));
    EXPECT_THAT(text, Not(HasSubstr("embree-robust")));
}

TEST(RatioTable, ComparesWithinOneNumberOfThreads) {
    std::vector<BenchRow> rows{make_row("a", "fast", 0.25, 3.0),
                               make_row("a", "embree-robust", 0.5, 2.0)};
    rows[1].threads = 2;
    EXPECT_THAT(ratio_table(rows), testing::ContainsRegex("\nfast +1 a +- +- +- +-\n"));
}

TEST(RatioTable, IsEmptyWithoutPeersOrWithoutMethods) {
    EXPECT_EQ(ratio_table(std::vector{make_row("a", "fast", 0.25, 3.0)}), "");
    EXPECT_EQ(ratio_table(std::vector{make_row("a", "embree-high", 0.25, 3.0)}), "");
    EXPECT_EQ(ratio_table({}), "");
}

}  // namespace

}  // namespace coppice::lab
