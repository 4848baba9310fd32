#include "experiment/experiment.h"

#include "coppice/base/error.h"

#include "experiment/scene_rays.h"
#include "rows/drift.h"
#include "support/lab_scenes.h"
#include "tracers/contestant.h"

#include <gmock/gmock.h>

#include <cmath>
#include <map>
#include <sstream>
#include <tuple>

namespace coppice::lab {

namespace {

using test::TemporaryFolder;

/// Everything an experiment told, in order.
struct Told {
    std::vector<ExperimentProgress> progress;
    std::vector<std::string> scenes;
    std::vector<std::string> notes;

    [[nodiscard]] ExperimentObserver observer() {
        return {[this](const ExperimentProgress& now) { progress.push_back(now); },
                [this](const SceneResult& scene) { scenes.push_back(scene.scene); },
                [this](const std::string& note) { notes.push_back(note); }};
    }

    [[nodiscard]] std::vector<std::string> steps() const {
        std::vector<std::string> steps;
        for (const ExperimentProgress& now : progress) {
            steps.push_back(now.step);
        }
        return steps;
    }
};

std::vector<double> percents_of(const SceneResult& scene) {
    std::vector<double> percents;
    for (const ResultRow& row : scene.rows) {
        percents.push_back(row.sample_percent);
    }
    return percents;
}

ExperimentOptions small_options(const std::filesystem::path& scene) {
    ExperimentOptions options;
    options.scenes = {scene};
    options.percents = {100, 20, 5};
    return options;
}

std::string failure_of(const ExperimentOptions& options) {
    try {
        static_cast<void>(run_experiment(options));
    } catch (const Error& error) {
        return error.what();
    }
    return "";
}

/// "points fixed 1 100": what a row is of.
std::string key_of(const ResultRow& row) {
    std::ostringstream key;
    key << row.primitives << ' ' << row.protocol << ' ' << row.seed << ' ' << row.sample_percent;
    return key.str();
}

TEST(Experiment, RowsByKindProtocolSeedAndRate) {
    const TemporaryFolder folder;
    ExperimentOptions options = small_options(folder.make_scene("hills.ply", "terrain", 400));
    options.percents = {100, 5};
    options.seed_count = 2;
    options.protocols = {"scaled", "fixed"};
    const SceneResult result = run_experiment(options).at(0);
    std::vector<std::string> keys;
    for (const ResultRow& row : result.rows) {
        keys.push_back(key_of(row));
        EXPECT_EQ(row.scene, "hills");
        EXPECT_EQ(sample_of(row.report.options).seed, row.seed);
        EXPECT_EQ(sample_of(row.report.options).rate, row.sample_percent / 100.0);
    }
    EXPECT_THAT(keys, testing::ElementsAre(
                          "points scaled 1 100", "points scaled 1 5", "points scaled 2 100",
                          "points scaled 2 5", "points fixed 1 100", "points fixed 1 5",
                          "points fixed 2 100", "points fixed 2 5", "triangles scaled 1 100",
                          "triangles scaled 1 5", "triangles scaled 2 100", "triangles scaled 2 5",
                          "triangles fixed 1 100", "triangles fixed 1 5", "triangles fixed 2 100",
                          "triangles fixed 2 5"));
    EXPECT_EQ(result.recommended.size(), 4U);
    EXPECT_EQ(result.knees.size(), 4U);
}

TEST(Experiment, CountsOfTheScene) {
    const TemporaryFolder folder;
    const auto file = folder.make_file("quad.obj",
                                       "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 0 0 0\n"
                                       "f 1 2 3\nf 5 3 4\n");
    const auto results = run_experiment(small_options(file));
    EXPECT_EQ(results[0].vertex_count, 5U);
    EXPECT_EQ(results[0].distinct_vertex_count, 4U);
    EXPECT_EQ(results[0].triangle_count, 2U);
    EXPECT_EQ(results[0].load_report.duplicate_vertices.count, 1U);
    EXPECT_EQ(results[0].bounds, (Aabb{{0, 0, 0}, {1, 1, 0}}));
    for (const ResultRow& row : results[0].rows) {
        EXPECT_EQ(row.report.primitive_count, row.primitives == "points" ? 4U : 2U);
    }
}

TEST(Experiment, RelativeCostIsAgainstTheFullTreeOfTheSameSeriesAndSeed) {
    const TemporaryFolder folder;
    ExperimentOptions options = small_options(folder.make_scene("balls.ply", "spheres", 2000));
    options.seed_count = 2;
    const auto results = run_experiment(options);
    using Series = std::tuple<std::string, std::string, std::uint64_t>;
    const auto series_of = [](const ResultRow& row) {
        return Series{row.primitives, row.protocol, row.seed};
    };
    std::map<Series, double> references;
    for (const ResultRow& row : results[0].rows) {
        if (row.sample_percent == 100) references[series_of(row)] = row.report.statistics.sah_cost;
    }
    ASSERT_EQ(references.size(), 12U);
    for (const ResultRow& row : results[0].rows) {
        EXPECT_EQ(row.relative_cost,
                  row.report.statistics.sah_cost / references.at(series_of(row)));
    }
}

TEST(Experiment, FullTreeIsTheReferenceEvenIfNotAskedFor) {
    const TemporaryFolder folder;
    ExperimentOptions options = small_options(folder.make_scene("hills.ply", "terrain", 1000));
    options.primitives = {PrimitiveKind::triangles};
    options.protocols = {"fixed"};
    const auto with_all = run_experiment(options);
    options.percents = {20, 5};
    Told told;
    const auto without = run_experiment(options, told.observer());
    EXPECT_THAT(percents_of(without[0]), testing::ElementsAre(20, 5));
    EXPECT_EQ(without[0].rows[0].relative_cost, with_all[0].rows[1].relative_cost);
    EXPECT_EQ(without[0].rows[1].relative_cost, with_all[0].rows[2].relative_cost);
    EXPECT_THAT(told.notes, testing::ElementsAre(testing::HasSubstr("100 %")));
    EXPECT_THAT(told.steps(), testing::ElementsAre("loading", "triangles, fixed, 100 %, seed 1",
                                                   "triangles, fixed, 20 %, seed 1",
                                                   "triangles, fixed, 5 %, seed 1"));
}

TEST(Experiment, RowsKeepTheOrderAskedForButTheFullTreeIsBuiltFirst) {
    const TemporaryFolder folder;
    ExperimentOptions options = small_options(folder.make_scene("hills.ply", "terrain", 400));
    options.primitives = {PrimitiveKind::points};
    options.protocols = {"grown"};
    options.percents = {0.5, 50, 100, 10};
    Told told;
    const auto results = run_experiment(options, told.observer());
    EXPECT_THAT(percents_of(results[0]), testing::ElementsAre(0.5, 50, 100, 10));
    EXPECT_EQ(told.steps()[1], "points, grown, 100 %, seed 1");
    EXPECT_EQ(results[0].rows[2].relative_cost, 1.0);
    EXPECT_TRUE(told.notes.empty());
}

TEST(Experiment, ProgressCountsAllTreesAndSaysHowLongTheRestTakes) {
    const TemporaryFolder folder;
    const ExperimentOptions options = small_options(folder.make_scene("hills.ply", "terrain", 400));
    Told told;
    static_cast<void>(run_experiment(options, told.observer()));
    ASSERT_EQ(told.progress.size(), 19U);
    for (std::size_t i = 1; i < told.progress.size(); ++i) {
        const ExperimentProgress& now = told.progress[i];
        EXPECT_EQ(now.rows_done, i - 1);
        EXPECT_EQ(now.row_count, 18U);
        EXPECT_EQ(now.remaining_seconds.has_value(), i > 1) << i;
    }
}

TEST(Experiment, MethodsAndSamplersAreMoreRows) {
    const TemporaryFolder folder;
    ExperimentOptions options = small_options(folder.make_scene("hills.ply", "terrain", 400));
    options.protocols = {"scaled"};
    options.methods = {"sampled", "binned", "fast"};
    options.samplers = {"uniform", "weighted"};
    options.percents = {5, 100};
    const SceneResult result = run_experiment(options).at(0);
    std::vector<std::string> keys;
    for (const ResultRow& row : result.rows) {
        keys.push_back(key_of(row) + ' ' + row.sampler);
        EXPECT_EQ(sample_of(row.report.options).rate,
                  row.sampler.empty() ? 1.0 : row.sample_percent / 100.0);
    }
    // `binned` does not sample, `fast` is over triangles, so few of which it does not sample.
    EXPECT_THAT(keys, testing::ElementsAre(
                          "points scaled 1 5 uniform", "points scaled 1 100 uniform",
                          "points scaled 1 5 weighted", "points scaled 1 100 weighted",
                          "points sampled 1 5 uniform", "points sampled 1 100 uniform",
                          "points sampled 1 5 weighted", "points sampled 1 100 weighted",
                          "points binned 1 100 ", "triangles scaled 1 5 uniform",
                          "triangles scaled 1 100 uniform", "triangles scaled 1 5 weighted",
                          "triangles scaled 1 100 weighted", "triangles sampled 1 5 uniform",
                          "triangles sampled 1 100 uniform", "triangles sampled 1 5 weighted",
                          "triangles sampled 1 100 weighted", "triangles binned 1 100 ",
                          "triangles fast 1 100 uniform"));
    EXPECT_EQ(result.knees.size(), 8U) << "by kind, builder and sampler, where there are rates";
}

TEST(Experiment, AMethodKeepsItsOwnSampler) {
    const TemporaryFolder folder;
    ExperimentOptions options = small_options(folder.make_scene("hills.ply", "terrain", 400));
    options.primitives = {PrimitiveKind::triangles};
    options.protocols = {"grown"};
    options.methods = {"fast"};
    options.percents = {100};
    options.build.cost.traversal = 15.0;
    const auto rows = run_experiment(options).at(0).rows;
    ASSERT_EQ(rows.size(), 2U);
    EXPECT_EQ(rows[0].sampler, "uniform");
    EXPECT_EQ(rows[1].sampler, "weighted");
    EXPECT_EQ(cost_of(rows[1].report.options).traversal, 15.0);
}

TEST(Experiment, RaysAreTracedThroughTreesOfTriangles) {
    const TemporaryFolder folder;
    ExperimentOptions options = small_options(folder.make_scene("balls.ply", "spheres", 600));
    options.methods = {"fast"};
    options.protocols = {"fixed"};
    options.percents = {100, 5};
    options.rays = {RayKind::primary, RayKind::shadow, RayKind::axis};
    options.size = 16;
    for (const Peer& peer : peer_registry()) {
        options.methods.emplace_back(peer.name);
    }
    const SceneResult result = run_experiment(options).at(0);
    ASSERT_TRUE(result.view);
    EXPECT_TRUE(result.errors.empty());
    for (const ResultRow& row : result.rows) {
        ASSERT_EQ(row.rays.size(), row.primitives == "points" ? 0U : 3U);
        for (const RayFigures& figures : row.rays) {
            EXPECT_EQ(figures.rays, 256U);
            if (row.form != TreeForm::peer) {  // Embree misses some of the rays through vertices
                EXPECT_EQ(figures.mismatches, 0U) << row.protocol;
            }
            EXPECT_GT(figures.wall_seconds, 0.0);
            EXPECT_EQ(figures.steps.has_value(), row.form != TreeForm::peer);
            if (figures.steps) {
                EXPECT_GT(figures.steps->nodes + figures.steps->primitives, 0.0);
            }
        }
        EXPECT_EQ(std::isfinite(row.report.statistics.sah_cost), row.form != TreeForm::peer);
    }
    EXPECT_GT(result.rows.at(2).rays.at(0).steps->primitives, 0.0);
    // Five sampled per cent end in larger leaves than all.
    EXPECT_GT(result.rows.at(3).rays.at(2).steps->primitives,
              result.rows.at(2).rays.at(2).steps->primitives);
}

TEST(Experiment, TimesOfRaysAreWithoutTheMachinesDrift) {
    const auto row_of = [](double wall, double reference) {
        ResultRow row;
        row.rays.push_back({.rays = 9, .wall_seconds = wall, .reference_seconds = reference});
        return row;
    };
    // While the second one was traced, everything took twice as long.
    std::vector<ResultRow> rows{row_of(4.0, 1.0), row_of(8.0, 2.0), row_of(3.0, 1.0)};
    remove_drift(rows);
    EXPECT_EQ(rows[0].rays[0].wall_seconds, 4.0);
    EXPECT_EQ(rows[1].rays[0].wall_seconds, 4.0);
    EXPECT_EQ(rows[2].rays[0].wall_seconds, 3.0);
    EXPECT_EQ(drift_range(rows), std::pair(1.0, 2.0));
}

TEST(Experiment, PointCloudRunsPointsOnlyAndSaysSo) {
    const TemporaryFolder folder;
    Told told;
    const auto results =
        run_experiment(small_options(folder.make_point_cloud("cloud.ply")), told.observer());
    EXPECT_EQ(results[0].rows.size(), 9U);
    for (const ResultRow& row : results[0].rows) {
        EXPECT_EQ(row.primitives, "points");
    }
    EXPECT_THAT(told.notes, testing::ElementsAre(testing::HasSubstr("only points")));
}

TEST(Experiment, PointCloudRefusesTrianglesThatWereAskedFor) {
    const TemporaryFolder folder;
    ExperimentOptions options = small_options(folder.make_point_cloud("cloud.ply"));
    options.primitives = {PrimitiveKind::points, PrimitiveKind::triangles};
    EXPECT_THAT(failure_of(options), testing::HasSubstr("without triangles"));
    options.primitives = {PrimitiveKind::points};
    EXPECT_EQ(failure_of(options), "");
}

TEST(Experiment, ScenesOfOneNameAreToldApart) {
    const TemporaryFolder folder;
    ExperimentOptions options = small_options(folder.make_scene("hills.ply", "terrain", 100));
    options.scenes.push_back(folder.make_scene("hills.obj", "terrain", 200));
    Told told;
    const auto results = run_experiment(options, told.observer());
    EXPECT_THAT(told.scenes, testing::ElementsAre("hills", "hills-2"));
    EXPECT_EQ(results[1].rows[0].scene, "hills-2");
    EXPECT_EQ(results[1].file, options.scenes[1]);
}

TEST(Experiment, ABadSceneAmongSeveralIsFoundBeforeTheFirstTree) {
    const TemporaryFolder folder;
    ExperimentOptions options = small_options(folder.make_scene("hills.ply", "terrain", 100));
    options.scenes.push_back(folder.make_file("broken.obj", "v 0 0 0\nv 1 0 0\nf 1 2 9\n"));
    Told told;
    try {
        static_cast<void>(run_experiment(options, told.observer()));
        FAIL() << "did not throw";
    } catch (const Error& error) {
        EXPECT_THAT(error.what(), testing::HasSubstr("broken.obj:3: "));
    }
    EXPECT_THAT(told.steps(), testing::ElementsAre("loading", "loading"));
}

TEST(Experiment, OddScenesHaveFiniteCosts) {
    const TemporaryFolder folder;
    const std::map<std::string, std::string> scenes{
        {"one.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n"},
        {"equal.obj", "v 1 1 1\nv 1 1 1\nv 1 1 1\nf 1 2 3\n"},
        {"line.obj", "v 0 0 0\nv 1 0 0\nv 2 0 0\nf 1 2 3\nf 2 3 1\n"}};
    for (const auto& [name, text] : scenes) {
        for (const double traversal : {0.0, 1.0}) {
            ExperimentOptions options = small_options(folder.make_file(name, text));
            options.build.cost.traversal = traversal;
            options.build.split.max_leaf = 1;
            const auto results = run_experiment(options);
            for (const ResultRow& row : results[0].rows) {
                EXPECT_TRUE(std::isfinite(row.report.statistics.sah_cost)) << name;
                EXPECT_TRUE(std::isfinite(row.relative_cost)) << name << ' ' << row.sample_percent;
            }
        }
    }
}

TEST(Experiment, OptionsOutOfRangeAreRefused) {
    const TemporaryFolder folder;
    const ExperimentOptions good = small_options(folder.make_scene("hills.ply", "terrain", 100));
    const auto expect_refused = [&](auto&& spoil) {
        ExperimentOptions options = good;
        spoil(options);
        EXPECT_NE(failure_of(options), "");
    };
    expect_refused([](ExperimentOptions& o) { o.scenes.clear(); });
    expect_refused([](ExperimentOptions& o) { o.protocols.clear(); });
    expect_refused([](ExperimentOptions& o) { o.protocols = {"fixed", "fixed"}; });
    expect_refused([](ExperimentOptions& o) { o.protocols = {"grwon"}; });
    expect_refused([](ExperimentOptions& o) { o.percents.clear(); });
    expect_refused([](ExperimentOptions& o) { o.percents = {0}; });
    expect_refused([](ExperimentOptions& o) { o.percents = {100.5}; });
    expect_refused([](ExperimentOptions& o) { o.percents = {10, 10}; });
    expect_refused([](ExperimentOptions& o) { o.seed_count = 0; });
    expect_refused([](ExperimentOptions& o) { o.build.split.rule = "best"; });
    expect_refused([](ExperimentOptions& o) { o.methods = {"auto"}; });
    expect_refused([](ExperimentOptions& o) { o.methods = {"fast", "fast"}; });
    expect_refused([](ExperimentOptions& o) { o.samplers = {"unifrom"}; });
    expect_refused([](ExperimentOptions& o) { o.rays = {RayKind::axis, RayKind::axis}; });
    expect_refused([](ExperimentOptions& o) { o.size = 0; });
    expect_refused([](ExperimentOptions& o) {
        o.primitives = {PrimitiveKind::points, PrimitiveKind::points};
    });
}

}  // namespace

}  // namespace coppice::lab
