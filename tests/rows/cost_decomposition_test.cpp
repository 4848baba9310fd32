#include "rows/cost_decomposition.h"

#include "experiment/experiment.h"
#include "support/lab_scenes.h"

#include <gtest/gtest.h>

namespace coppice::lab {

namespace {

ResultRow row_of(const char* protocol, double percent, double cost, double tests = 0.0,
                 std::uint64_t references = 100) {
    ResultRow row;
    row.protocol = protocol;
    row.sample_percent = percent;
    row.report.primitive_count = 100;
    row.report.statistics.sah_cost = cost;
    row.report.statistics.expected_primitive_tests = tests;
    row.report.statistics.reference_count = references;
    return row;
}

TEST(CostDecomposition, OfKnownTrees) {
    std::vector<ResultRow> rows{
        row_of("fixed", 100, 50, 20, 200),  row_of("fixed", 10, 120),
        row_of("scaled", 100, 50, 20, 200), row_of("scaled", 10, 80, 44, 400),
        row_of("grown", 100, 40, 10, 200),  row_of("grown", 10, 45, 16, 400)};
    rows[3].unsampled_tests = 4.0;
    const std::vector<CostParts> parts = decompose_costs(rows);
    ASSERT_EQ(parts.size(), 3U);
    EXPECT_EQ(parts[0].protocol, "fixed");
    EXPECT_DOUBLE_EQ(parts[0].excess, 70.0 / 50);
    EXPECT_DOUBLE_EQ(parts[0].early_stop, 40.0 / 50);
    EXPECT_DOUBLE_EQ(parts[0].empty_cells, 4.0 / 50);
    EXPECT_DOUBLE_EQ(parts[0].duplicates, (0.75 * 40 - 0.5 * 20) / 50);
    EXPECT_DOUBLE_EQ(parts[0].plane_error, ((45 - 0.75 * 16) - (40 - 0.5 * 10)) / 50);
    EXPECT_DOUBLE_EQ(parts[1].early_stop, 0.0);
    EXPECT_NEAR(parts[1].uneven_leaves, parts[0].uneven_leaves, 1e-12);
    EXPECT_DOUBLE_EQ(parts[2].duplicates, (0.75 * 16 - 0.5 * 10) / 40);
    EXPECT_NEAR(parts[2].uneven_leaves, 0.0, 1e-12);
    rows.erase(rows.begin() + 4);
    EXPECT_TRUE(decompose_costs(rows).empty()) << "grown without its full tree";
}

TEST(CostDecomposition, PartsAddUpForRealTrees) {
    const test::TemporaryFolder folder;
    ExperimentOptions options;
    options.scenes = {folder.make_scene("balls.ply", "spheres", 2000)};
    options.percents = {100, 10};
    options.seed_count = 2;
    const std::vector<CostParts> all = decompose_costs(run_experiment(options).at(0).rows);
    ASSERT_EQ(all.size(), 12U);
    for (const CostParts& parts : all) {
        EXPECT_NEAR(parts.excess,
                    parts.early_stop + parts.empty_cells + parts.duplicates + parts.plane_error +
                        parts.uneven_leaves,
                    1e-12);
        if (parts.protocol != "grown") {
            EXPECT_GT(parts.empty_cells, 0.0) << parts.primitives;
        }
        if (parts.primitives == "points") {
            EXPECT_EQ(parts.duplicates, 0.0);
        }
        if (parts.protocol == "fixed" && parts.primitives == "points") {
            EXPECT_GT(parts.early_stop, 1.0);
        }
    }
}

}  // namespace

}  // namespace coppice::lab
