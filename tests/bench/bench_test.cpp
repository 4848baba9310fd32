#include "bench/bench.h"

#include "coppice/base/error.h"

#include "support/lab_scenes.h"
#include "tracers/contestant.h"

#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

namespace coppice::lab {

namespace {

using test::TemporaryFolder;

/// A benchmark of a small scene that is over at once.
BenchOptions small_bench(const TemporaryFolder& folder) {
    BenchOptions options;
    options.scenes = {folder.make_scene("balls.ply", "spheres", 500)};
    options.methods = {"sampled", "sweep"};
    options.threads = {1};
    options.runs = 2;
    options.size = 16;
    return options;
}

std::vector<std::string> peer_names() {
    std::vector<std::string> names;
    for (const Peer& peer : peer_registry()) {
        names.emplace_back(peer.name);
    }
    return names;
}

TEST(RunBench, HasARowForEveryThreadCountAndContestant) {
    const TemporaryFolder folder;
    BenchOptions options = small_bench(folder);
    options.threads = {2, 1};
    options.peers = peer_names();
    const BenchResult result = run_bench(options);
    std::vector<std::string> expected = options.methods;
    expected.insert(expected.end(), options.peers.begin(), options.peers.end());
    ASSERT_EQ(result.rows.size(), 2 * expected.size());
    for (std::size_t i = 0; i < result.rows.size(); ++i) {
        const BenchRow& row = result.rows[i];
        EXPECT_EQ(row.method, expected[i % expected.size()]);
        EXPECT_EQ(row.threads, i < expected.size() ? 2 : 1);
        EXPECT_EQ(row.is_peer, i % expected.size() >= options.methods.size());
        EXPECT_EQ(row.scene, "balls");
        EXPECT_EQ(row.triangles, result.scenes[0].triangles);
        EXPECT_EQ(row.sah_cost.has_value(), !row.is_peer);
        EXPECT_EQ(row.references_per_triangle.has_value(), !row.is_peer);
        for (const double figure :
             {row.build_seconds, row.build_seconds_first, row.build_cpu_seconds,
              row.bytes_per_triangle, row.peak_bytes_per_triangle, row.mrays[0].value_or(0.0),
              row.mrays[1].value_or(0.0), row.mrays[2].value_or(0.0)}) {
            EXPECT_GT(figure, 0.0) << row.method;
        }
        EXPECT_EQ(row.mismatches, 0U) << row.method;
    }
}

TEST(RunBench, ComparesWithTheRobustPeerOrElseTheFirst) {
    const TemporaryFolder folder;
    BenchOptions options = small_bench(folder);
    options.runs = 1;
    EXPECT_EQ(run_bench(options).scenes[0].reference, "sampled");
    if (peer_registry().empty()) GTEST_SKIP() << "built without Embree";
    options.peers = {"embree-low", "embree-robust"};
    EXPECT_EQ(run_bench(options).scenes[0].reference, "embree-robust");
}

TEST(RunBench, TracesOnlyWhatIsAskedFor) {
    const TemporaryFolder folder;
    BenchOptions options = small_bench(folder);
    options.rays = {RayKind::diffuse};
    BenchResult result = run_bench(options);
    EXPECT_EQ(result.scenes[0].ray_counts[0], 256U);
    EXPECT_EQ(result.scenes[0].ray_counts[1], 0U);
    EXPECT_GT(result.scenes[0].ray_counts[2], 0U);
    EXPECT_FALSE(result.rows[0].mrays[0].has_value());
    EXPECT_FALSE(result.rows[0].mrays[1].has_value());
    EXPECT_TRUE(result.rows[0].mrays[2].has_value());

    options.camera.eye = Vec3f{1000.0F, 1000.0F, 1000.0F};
    options.camera.look_at = Vec3f{2000.0F, 1000.0F, 1000.0F};
    result = run_bench(options);
    EXPECT_EQ(result.scenes[0].ray_counts[2], 0U);
    EXPECT_FALSE(result.rows[0].mrays[2].has_value()) << "nothing is hit, nothing bounces";
}

TEST(RunBench, TellsHowItGoesOn) {
    const TemporaryFolder folder;
    BenchOptions options = small_bench(folder);
    options.scenes.push_back(folder.make_scene("hills.ply", "terrain", 300));
    std::vector<std::string> steps;
    std::vector<std::string> scenes;
    const BenchObserver observer{
        [&](const std::string& step, std::optional<double>) { steps.push_back(step); },
        [&](const BenchScene& scene, std::span<const BenchRow> rows) {
            scenes.push_back(scene.scene);
            EXPECT_EQ(rows.size(), 2U);
        }};
    static_cast<void>(run_bench(options, observer));
    EXPECT_THAT(scenes, testing::ElementsAre("balls", "hills"));
    EXPECT_THAT(steps, testing::Contains("balls: loading"));
    EXPECT_THAT(steps, testing::Contains("balls, 1 thread: sampled, first run"));
    EXPECT_THAT(steps, testing::Contains("hills, 1 thread: sweep, run 2 of 2"));
}

TEST(RunBench, RefusesWhatCannotBeMeasured) {
    const TemporaryFolder folder;
    const BenchOptions good = small_bench(folder);
    const auto refuses = [](BenchOptions options, auto&& change) {
        change(options);
        EXPECT_THROW(static_cast<void>(run_bench(options)), Error);
    };
    refuses(good, [](BenchOptions& options) { options.methods = {"best"}; });
    refuses(good, [](BenchOptions& options) { options.peers = {"best"}; });
    refuses(good, [](BenchOptions& options) { options.methods = {}; });
    refuses(good, [](BenchOptions& options) { options.threads = {0}; });
    refuses(good, [](BenchOptions& options) { options.runs = 0; });
    refuses(good, [](BenchOptions& options) { options.size = 0; });
    refuses(good, [](BenchOptions& options) { options.camera.fov = 180.0; });
    refuses(good, [](BenchOptions& options) { options.scenes = {"missing.obj"}; });
    refuses(good, [&](BenchOptions& options) {
        options.scenes = {folder.make_point_cloud("cloud.ply")};
    });
}

}  // namespace

}  // namespace coppice::lab
