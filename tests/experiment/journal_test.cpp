#include "experiment/journal.h"

#include "coppice/base/error.h"
#include "coppice/json/build_options.h"
#include "coppice/json/tree_statistics.h"

#include "experiment/experiment.h"
#include "support/lab_scenes.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <cmath>
#include <fstream>
#include <limits>

namespace coppice::lab {

namespace {

using test::TemporaryFolder;

ExperimentOptions small_options(const TemporaryFolder& folder) {
    ExperimentOptions options;
    options.scenes = {folder.make_scene("hills.ply", "terrain", 300)};
    options.protocols = {"fixed", "grown"};
    options.methods = {"binned", "fast"};
    options.samplers = {"uniform", "weighted"};
    options.rays = {RayKind::shadow, RayKind::random};
    options.size = 8;
    options.camera.eye = Vec3f{0.1F, 7.0F, 0.3F};
    options.percents = {100, 0.3};
    options.seed_count = 2;
    options.tolerance = 0.07;
    options.build.cost = {15.0, 20.0, 0.1};
    options.build.split.max_leaf = 7;
    options.build.split.clipping = Clipping::bounding_box;
    options.build.threads = 1;
    options.out = folder.path() / "out";
    return options;
}

ExperimentObserver observer_of(Journal& journal) {
    ExperimentObserver observer;
    observer.find_finished = [&](const TreeKey& key) { return journal.find(key); };
    observer.on_row = [&](const TreeKey& key, const TreeFigures& figures) {
        journal.add(key, figures);
    };
    return observer;
}

/// Cuts the file to so many lines and half of the next.
void cut(const std::filesystem::path& file, int line_count) {
    const std::string text = test::read_file(file);
    std::size_t end = 0;
    for (int i = 0; i < line_count; ++i) {
        end = text.find('\n', end) + 1;
    }
    std::filesystem::resize_file(file, std::min<std::size_t>(end + 40, text.size()));
}

TEST(Journal, ARunThatWasCutShortEndsWithTheSameRows) {
    const TemporaryFolder folder;
    const ExperimentOptions options = small_options(folder);
    Journal first = Journal::begin(options, {"coppice", "experiment"});
    EXPECT_FALSE(Journal::exists(options.out)) << "nothing is written before the first tree";
    const auto expected = run_experiment(options, observer_of(first));
    ASSERT_TRUE(Journal::exists(options.out));
    cut(options.out / Journal::file_name, 6);

    Journal second = Journal::open(options.out);
    EXPECT_EQ(second.row_count(), 5U);
    EXPECT_EQ(nlohmann::json(second.options()), nlohmann::json(options));
    EXPECT_TRUE(second.options().primitives.empty());
    EXPECT_EQ(second.command(), first.command());
    const auto resumed = run_experiment(second.options(), observer_of(second));
    ASSERT_EQ(resumed[0].rows.size(), expected[0].rows.size());
    EXPECT_EQ(resumed[0].distinct_vertex_count, expected[0].distinct_vertex_count);
    for (std::size_t i = 0; i < resumed[0].rows.size(); ++i) {
        const ResultRow& row = resumed[0].rows[i];
        const ResultRow& other = expected[0].rows[i];
        EXPECT_EQ(nlohmann::json(row.report.statistics), nlohmann::json(other.report.statistics));
        EXPECT_EQ(nlohmann::json(row.report.options), nlohmann::json(other.report.options));
        EXPECT_EQ(row.relative_cost, other.relative_cost);
        EXPECT_EQ(row.unsampled_tests, other.unsampled_tests);
        const bool is_restored = i < 5;  // rates are in the order they are built in
        if (is_restored) {
            EXPECT_EQ(row_json(row, options.rays), row_json(other, options.rays)) << i;
        }
    }

    // All is there now: nothing is built, and everything is the same to the bit.
    Journal third = Journal::open(options.out);
    // Six trees by `fast` are no rows: so few triangles are not sampled, by no sampler.
    EXPECT_EQ(third.row_count(), resumed[0].rows.size() + 6);
    const auto again = run_experiment(third.options(), observer_of(third));
    EXPECT_EQ(csv_text(again, options.rays), csv_text(resumed, options.rays));
    third.remove();
    EXPECT_FALSE(Journal::exists(options.out));
}

TEST(Journal, KeepsCostsThatAreNotFinite) {
    const TemporaryFolder folder;
    ExperimentOptions options = small_options(folder);
    Journal journal = Journal::begin(options, {});
    TreeFigures figures;
    TreeStatistics& statistics = figures.report.statistics;
    statistics.sah_cost = std::numeric_limits<double>::infinity();
    statistics.cost_share_by_depth = {std::numeric_limits<double>::quiet_NaN()};
    const TreeKey key{{"points", "fixed"}, "\xff", 0.1, 3};
    journal.add(key, figures);
    const auto found = Journal::open(options.out).find(key);
    ASSERT_TRUE(found);
    EXPECT_FALSE(std::isfinite(found->report.statistics.sah_cost));
    EXPECT_EQ(found->report.statistics.cost_share_by_depth.size(), 1U);
    EXPECT_FALSE(journal.find({{"points", "fixed"}, "hills", 0.1, 3}));
}

TEST(Journal, RefusesWhatItCannotGoOnWith) {
    const TemporaryFolder folder;
    const ExperimentOptions options = small_options(folder);
    const auto refuses = [&] {
        try {
            static_cast<void>(Journal::open(options.out));
        } catch (const Error&) {
            return true;
        }
        return false;
    };
    EXPECT_TRUE(refuses()) << "there is none";
    Journal journal = Journal::begin(options, {});
    journal.add({{"points", "fixed"}, "hills", 100, 1}, {});
    EXPECT_FALSE(refuses());
    cut(options.out / Journal::file_name, 1);
    EXPECT_FALSE(refuses()) << "the first line alone";
    std::ofstream(options.scenes[0], std::ios::app) << "more";
    EXPECT_TRUE(refuses()) << "the scene has changed";
    for (const char* text : {"", "{", "{}\n", "[]\n", "x\n", "{\"format\": 99}\n"}) {
        std::ofstream(options.out / Journal::file_name) << text;
        EXPECT_TRUE(refuses()) << text;
    }
}

}  // namespace

}  // namespace coppice::lab
