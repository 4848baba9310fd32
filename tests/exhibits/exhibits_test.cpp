#include "exhibits/exhibits.h"

#include "coppice/builders/build_tree.h"
#include "coppice/cost/measure.h"

#include "exhibits/scene_outline.h"
#include "exhibits/scene_picture.h"
#include "exhibits/tree_cells.h"
#include "experiment/experiment.h"
#include "scenes/room_view.h"
#include "support/lab_scenes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <vector>

namespace coppice::lab {

namespace {

TEST(TreeCells, AreAllNodesOfEveryLevelWithTheirShareOfTheCost) {
    const TriangleMesh mesh = make_procedural("spheres", 3000, 1);
    const SahCostModel cost{15.0, 20.0, 0.2};
    const KdTree tree = build_kd_tree(mesh.view(), {.cost = cost}).tree;
    const TreeStatistics statistics = measure(tree, cost);
    const auto levels = collect_cells(tree, cost, 1'000'000);
    ASSERT_EQ(levels.size(), static_cast<std::size_t>(statistics.max_level) + 1);
    std::uint64_t cells = 0;
    std::uint64_t empty = 0;
    for (const report::CellLevel& level : levels) {
        EXPECT_EQ(level.shown.size(), level.cell_count);
        cells += level.cell_count;
        empty += level.empty_count;
    }
    EXPECT_EQ(cells, statistics.node_count);
    EXPECT_EQ(empty, statistics.empty_leaf_count);
    EXPECT_DOUBLE_EQ(levels[0].shown[0].cost_share, 1.0);
    EXPECT_EQ(levels[0].shown[0].reference_count, statistics.reference_count);
    // What is below the root is all but the root's own step.
    const auto& halves = levels[1].shown;
    EXPECT_NEAR(halves[0].cost_share + halves[1].cost_share,
                1.0 - cost.traversal / statistics.sah_cost, 1e-9);
    EXPECT_EQ(halves[0].reference_count + halves[1].reference_count, statistics.reference_count);
}

TEST(TreeCells, AreDrawnEvenlyWhereThereAreMany) {
    const TriangleMesh mesh = make_procedural("terrain", 2000, 1);
    const KdTree tree = build_kd_tree(mesh.view()).tree;
    const auto all = collect_cells(tree, {}, 1'000'000);
    const auto some = collect_cells(tree, {}, 7);
    ASSERT_EQ(some.size(), all.size());
    for (std::size_t depth = 0; depth < all.size(); ++depth) {
        EXPECT_EQ(some[depth].cell_count, all[depth].cell_count);
        EXPECT_EQ(some[depth].shown.size(), std::min<std::size_t>(7, all[depth].shown.size()));
    }
    EXPECT_NE(some[6].shown.front().box.lower, some[6].shown.back().box.lower);
}

TEST(SceneOutline, IsTheMeshItselfOrPointsOnEqualAreas) {
    // Two triangles of areas 1 and 3, and a vertex of neither.
    const TriangleMesh mesh{
        {{0, 0, 0}, {2, 0, 0}, {0, 1, 0}, {0, 0, 9}, {6, 0, 9}, {0, 1, 9}, {5, 5, 5}},
        {{0, 1, 2}, {3, 4, 5}}};
    const report::SceneOutline whole = outline_of(mesh, {.triangles = 2});
    EXPECT_EQ(whole.triangles, mesh.triangles);
    EXPECT_EQ(whole.positions, mesh.vertices);
    const report::SceneOutline points = outline_of(mesh, {.triangles = 1, .points = 400});
    EXPECT_TRUE(points.triangles.empty());
    ASSERT_EQ(points.positions.size(), 400U);
    EXPECT_EQ(points.shades.size(), 400U);
    EXPECT_EQ(std::count_if(points.positions.begin(), points.positions.end(),
                            [](Vec3f point) { return point.z == 0.0F; }),
              100);
    const TriangleMesh flat{{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}}, {{0, 1, 2}}};
    EXPECT_EQ(outline_of(flat, {.points = 2}).positions.size(), 2U);  // no area: vertices
}

// The twelve triangles of a box around the origin.
TriangleMesh box_of(float half) {
    TriangleMesh box;
    for (int i = 0; i < 8; ++i) {
        box.vertices.push_back({(i & 1) != 0 ? half : -half, (i & 2) != 0 ? half : -half,
                                (i & 4) != 0 ? half : -half});
    }
    box.triangles = {{0, 1, 3}, {0, 3, 2}, {4, 5, 7}, {4, 7, 6}, {0, 1, 5}, {0, 5, 4},
                     {2, 3, 7}, {2, 7, 6}, {0, 2, 6}, {0, 6, 4}, {1, 3, 7}, {1, 7, 5}};
    return box;
}

TEST(PictureCamera, StandsInsideARoomAndOutsideOfAllElse) {
    const auto eye_of = [](const TriangleMesh& mesh) {
        const auto tracer = build_picture_tree(mesh.view(), 1);
        const ChosenCamera chosen = choose_camera(mesh.view(), tracer, {}, 1.5);
        const Vec3f eye = chosen.camera.eye;
        EXPECT_EQ(bounds_of(mesh.vertices).contains(eye), chosen.is_inside);
        const Vec3f ray_eye = choose_ray_camera(mesh.view(), {}, 1).eye;
        EXPECT_EQ(bounds_of(mesh.vertices).contains(ray_eye), chosen.is_inside);
        return eye;
    };
    TriangleMesh room = box_of(1.0F);
    const Aabb inside = bounds_of(room.vertices);
    EXPECT_TRUE(inside.contains(eye_of(room)));
    const render::CameraWish from_far{.eye = Vec3f{9.0F, 0.0F, 0.0F}};
    EXPECT_EQ(choose_ray_camera(room.view(), from_far, 1).eye, *from_far.eye);
    room.triangles.erase(room.triangles.begin() + 6, room.triangles.begin() + 8);  // no ceiling
    EXPECT_FALSE(inside.contains(eye_of(room)));
    const TriangleMesh balls = make_procedural("spheres", 5000, 1);
    EXPECT_FALSE(bounds_of(balls.vertices).contains(eye_of(balls)));
}

class Exhibits : public testing::Test {
protected:
    report::SceneExhibits of(const std::filesystem::path& file) {
        options_.scenes = {file};
        options_.build.threads = 2;
        return make_exhibits(run_experiment(options_).front(), options_);
    }

    test::TemporaryFolder folder_;
    ExperimentOptions options_{.protocols = {"fixed", "grown"}, .percents = {100, 50, 10}};
};

TEST_F(Exhibits, AreOfTheFullTreeAndTheSmallestRecommended) {
    options_.tolerance = 0.5;
    const report::SceneExhibits exhibits = of(folder_.make_scene("balls.ply", "spheres", 2000));
    EXPECT_EQ(exhibits.missing, "");
    EXPECT_EQ(exhibits.kind, "triangles");
    EXPECT_EQ(exhibits.full.protocol, "grown");
    EXPECT_EQ(exhibits.full.percent, 100.0);
    ASSERT_TRUE(exhibits.other);
    EXPECT_EQ(exhibits.other->percent, 10.0);
    EXPECT_TRUE(exhibits.is_recommended);
    EXPECT_TRUE(exhibits.picture_camera.starts_with("--eye="));
    ASSERT_TRUE(exhibits.heat_maps);
    for (const report::Picture* picture :
         {&exhibits.picture, &exhibits.heat_maps->full, &exhibits.heat_maps->other,
          &exhibits.heat_maps->difference}) {
        EXPECT_EQ(picture->png.substr(1, 3), "PNG");
    }
    EXPECT_GT(exhibits.heat_maps->full_mean, 1.0);
    EXPECT_LT(exhibits.heat_maps->change.low, 0.0);
    ASSERT_TRUE(exhibits.inspector);
    EXPECT_FALSE(exhibits.inspector->other.empty());
    EXPECT_GT(exhibits.inspector->outline.triangles.size(), 1900U);
}

TEST_F(Exhibits, FallBackToTheLargestSmallerSample) {
    options_.protocols = {"fixed"};
    options_.primitives = {PrimitiveKind::points};
    options_.tolerance = 0.0;
    const report::SceneExhibits exhibits = of(folder_.make_scene("hills.ply", "terrain", 2000));
    EXPECT_FALSE(exhibits.is_recommended);
    ASSERT_TRUE(exhibits.other);
    EXPECT_EQ(exhibits.other->percent, 50.0);
    EXPECT_FALSE(exhibits.heat_maps);  // no tree of triangles
    EXPECT_NE(exhibits.missing, "");
    EXPECT_FALSE(exhibits.picture.png.empty());
}

TEST_F(Exhibits, SayWhatThereCannotBe) {
    const report::SceneExhibits cloud = of(folder_.make_point_cloud("cloud.ply"));
    EXPECT_TRUE(cloud.picture.png.empty());
    EXPECT_TRUE(cloud.inspector);
    EXPECT_NE(cloud.missing.find("point cloud"), std::string::npos);

    const auto file = folder_.make_scene("gone.ply", "spheres", 100);
    options_.scenes = {file};
    const std::vector<SceneResult> results = run_experiment(options_);
    std::filesystem::remove(file);
    EXPECT_NE(make_exhibits(results.front(), options_).missing.find("gone.ply"), std::string::npos);
}

}  // namespace

}  // namespace coppice::lab
