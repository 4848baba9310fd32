#include "experiment/result_table.h"

#include "experiment/experiment.h"
#include "support/lab_scenes.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <numeric>
#include <sstream>
#include <string>
#include <vector>

namespace coppice::lab {

namespace {

using testing::HasSubstr;

SceneResult run_small(int seed_count, const ExperimentObserver& observer = {}) {
    const test::TemporaryFolder folder;
    ExperimentOptions options;
    options.scenes = {folder.make_scene("hills.ply", "terrain", 400)};
    options.percents = {100, 10};
    options.seed_count = seed_count;
    return run_experiment(options, observer).front();
}

std::string whole_table(const SceneResult& scene) {
    return result_rows(scene) + result_choices(scene, 0.02);
}

std::size_t count_lines_like(const std::string& text, const std::string& pattern) {
    std::istringstream lines(text);
    std::size_t count = 0;
    for (std::string line; std::getline(lines, line);) {
        if (testing::Value(line, testing::ContainsRegex(pattern))) ++count;
    }
    return count;
}

TEST(ResultTable, OneTablePerKindOneBlockPerProtocol) {
    const std::string table = whole_table(run_small(1));
    EXPECT_EQ(count_lines_like(table, "hills, points: "), 1U);
    EXPECT_EQ(count_lines_like(table, "hills, triangles: "), 1U);
    EXPECT_EQ(count_lines_like(table, "^fixed: "), 2U);
    EXPECT_EQ(count_lines_like(table, "references"), 2U);
    EXPECT_EQ(count_lines_like(table, "^[* ] +100 .* 1\\.000$"), 6U);
    EXPECT_EQ(count_lines_like(table, "^\\* +[0-9]"), 6U);
    EXPECT_THAT(table, HasSubstr("recommended: the smallest sample whose cost is within 2 %"));
    EXPECT_THAT(table, HasSubstr("of one seed (no interval"));
}

TEST(ResultTable, LinesFitATerminalAndArePlain) {
    const std::string table = whole_table(run_small(1));
    std::istringstream lines(table);
    for (std::string line; std::getline(lines, line);) {
        EXPECT_LE(line.size(), 120U) << line;
    }
    EXPECT_TRUE(std::all_of(table.begin(), table.end(),
                            [](char c) { return c == '\n' || (c >= ' ' && c <= '~'); }));
}

TEST(ResultTable, SeedsAreAveragedWithTheirIntervals) {
    const SceneResult scene = run_small(3);
    const std::string table = whole_table(scene);
    EXPECT_THAT(table, HasSubstr("means of 3 seeds"));
    EXPECT_THAT(table, HasSubstr("with 95 % confidence (95 % t interval, 3 seeds)"));
    EXPECT_EQ(count_lines_like(table, "^[* ] +100 .* 1\\.000 [+]-0\\.000 +1\\.000 [+]-0\\.000$"),
              6U);
}

TEST(ResultTable, IsTheSameWrittenWhileRowsAreMeasured) {
    for (const int seed_count : {1, 2}) {
        std::vector<std::string> pieces;
        std::size_t written = 0;
        ExperimentObserver observer;
        observer.on_builder = [&](const SceneResult& so_far) {
            pieces.push_back(result_rows(so_far, written));
            written = so_far.rows.size();
        };
        const SceneResult scene = run_small(seed_count, observer);
        EXPECT_EQ(pieces.size(), 6U);  // two kinds, three protocols
        EXPECT_EQ(std::accumulate(pieces.begin(), pieces.end(), std::string()), result_rows(scene));
    }
}

TEST(ResultTable, OfNoRowsIsEmpty) {
    EXPECT_EQ(whole_table({}), "");
}

}  // namespace

}  // namespace coppice::lab
