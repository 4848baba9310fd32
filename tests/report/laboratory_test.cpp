#include "report/laboratory.h"

#include "report/charts_laboratory.h"
#include "report/results_fixture.h"

#include <gmock/gmock.h>

namespace coppice::report {
namespace {

using nlohmann::json;
using testing::HasSubstr;

json tree(const char* protocol, double percent) {
    return {{"protocol", protocol}, {"sampler", "uniform"}, {"sample_percent", percent}};
}

// A scene of three k-d trees, an 8-wide tree and a peer, with what rays measured.
json traced_scene() {
    json scene{{"scene", "hall"}, {"rows", json::array()}, {"details", json::array()}};
    const auto add = [&](const char* protocol, const char* form, double percent, const json& cost,
                         double nanoseconds) {
        json row = tree(protocol, percent);
        row.update({{"primitives", "triangles"},
                    {"split", form == std::string("kd") ? "sah" : ""},
                    {"seed", 1},
                    {"sah_cost", cost},
                    {"ray_nanoseconds", nanoseconds}});
        scene["rows"].push_back(row);
        row.update({{"tree", form}, {"cost_share_by_depth", {0.25, 0.75}}});
        scene["details"].push_back(row);
    };
    add("grown", "kd", 100, 40, 400);
    add("grown", "kd", 10, 44, 450);
    add("grown", "kd", 1, 60, 900);
    add("fast", "bvh8", 100, 12, 100);
    add("embree-high", "peer", 100, nullptr, 80);
    scene["recommended"] = {tree("grown", 10)};
    scene["recommended"][0]["primitives"] = "triangles";
    json parts = tree("grown", 10);
    parts.update({{"primitives", "triangles"},
                  {"excess", 0.1},
                  {"plane_error", 0.08},
                  {"duplicates", 0.03},
                  {"early_stop", 0.0},
                  {"empty_cells", 0.0},
                  {"uneven_leaves", -0.01}});
    scene["decomposition"] = {parts};
    json slow = tree("grown", 1);
    slow.update({{"build_seconds", 0.1}, {"ray_seconds", 9e-7}});
    json quick = tree("fast", 100);
    quick.update({{"build_seconds", 0.2}, {"ray_seconds", 1e-7}});
    scene["rays"] = {{"trees", {slow, quick}}, {"fastest", json::array()}};
    json first = tree("grown", 1);
    first.update({{"from_rays", 0.0}, {"to_rays", 125000.0}});
    json last = tree("fast", 100);
    last.update({{"from_rays", 125000.0}, {"to_rays", nullptr}});
    scene["rays"]["fastest"] = {first, last};
    scene["rays"]["correlations"] = {{{"tree", "kd"},
                                      {"rays", "all"},
                                      {"tree_count", 3},
                                      {"cost_with_time", 0.875},
                                      {"cost_with_steps", nullptr}}};
    scene["rays"]["calibrations"] = {{{"tree", "kd"},
                                      {"residuals", "absolute"},
                                      {"traversal_nanoseconds", 2.5},
                                      {"r_squared", 0.9},
                                      {"traversal_error", 0.25},
                                      {"caution", "rank-deficient: <"}}};
    return scene;
}

Series traced_series(const json& scene) {
    return collect_series({{"scenes", {scene}}}).at(0);
}

TEST(Laboratory, SeriesHaveOnlyTreesWhoseCostsCompare) {
    const Series series = traced_series(traced_scene());
    EXPECT_THAT(series.protocols(), testing::ElementsAre("grown"));
    EXPECT_EQ(series.points.size(), 3U);
}

TEST(Laboratory, ASamplerOfItsOwnIsALineOfItsOwn) {
    json scene = traced_scene();
    scene["rows"][2]["sampler"] = "weighted";
    scene["details"][2]["sampler"] = "weighted";
    const Series series = traced_series(scene);
    EXPECT_THAT(series.protocols(), testing::ElementsAre("grown", "grown, weighted"));
    EXPECT_NE(series.find("grown, weighted", 1.0), nullptr);
}

TEST(Laboratory, ChartsHaveTheirPoints) {
    const json scene = traced_scene();
    EXPECT_EQ(make_cost_ray_chart(scene, "kd")["data"]["values"].size(), 3U);
    EXPECT_EQ(make_cost_ray_chart(scene, "bvh8")["data"]["values"].size(), 1U);
    const json race = make_image_time_chart(scene);
    const json& winners = race["layer"][1]["data"]["values"];
    const auto starts =
        std::ranges::count_if(winners, [](const json& value) { return value["is_start"] == true; });
    EXPECT_EQ(starts, 1) << "one change of the fastest";
    const Series series = traced_series(scene);
    EXPECT_EQ(make_decomposition_chart(scene, series, "grown")["data"]["values"].size(), 5U);
    EXPECT_EQ(find_tree_pair(series).sampled->percent, 10.0) << "the one that is recommended";
    EXPECT_EQ(make_pair_level_chart(series)["data"]["values"].size(), 4U);
    const json nothing{{"scene", "x"}};
    EXPECT_TRUE(make_cost_ray_chart(nothing, "kd").is_null());
    EXPECT_TRUE(make_image_time_chart(nothing).is_null());
    EXPECT_TRUE(make_decomposition_chart(nothing, series, "grown").is_null());
}

TEST(Laboratory, SaysWhatWasFound) {
    const json scene = traced_scene();
    const std::string html = make_laboratory(scene, traced_series(scene));
    EXPECT_THAT(html,
                HasSubstr("0.875 with the time of a ray, not defined with its counted steps"));
    EXPECT_THAT(html, HasSubstr("rank-deficient: &lt;"));
    EXPECT_THAT(html, HasSubstr("Cost by depth, two trees side by side"));
    for (const char* id : {"hall-triangles-cost-ray-kd", "hall-triangles-image-time",
                           "hall-triangles-parts-grown", "hall-triangles-pair-levels"}) {
        EXPECT_THAT(html, HasSubstr("id=\"" + std::string(id) + "\"")) << id;
    }
    EXPECT_EQ(make_laboratory({{"scene", "x"}}, {}), "");
}

}  // namespace
}  // namespace coppice::report
