#include "rows/seed_summary.h"

#include <gtest/gtest.h>

namespace coppice::lab {

namespace {

ResultRow make_row(double percent, std::uint64_t seed, double cost, double relative_cost) {
    ResultRow row;
    row.primitives = "points";
    row.protocol = "fixed";
    row.sample_percent = percent;
    row.seed = seed;
    row.report.statistics.sah_cost = cost;
    row.report.stages.build.wall_seconds = 2.0;
    row.relative_cost = relative_cost;
    return row;
}

TEST(SummarizeSeeds, GivesMeansAndIntervalsByPercentage) {
    const std::vector<ResultRow> rows{make_row(100, 1, 8.0, 1.0), make_row(10, 1, 10.0, 1.25),
                                      make_row(100, 2, 4.0, 1.0), make_row(10, 2, 5.4, 1.35)};
    const auto summaries = summarize_seeds(rows);
    ASSERT_EQ(summaries.size(), 2U);
    EXPECT_EQ(summaries[0].sample_percent, 100);
    EXPECT_EQ(summaries[0].relative_cost.interval->high, 1.0);
    EXPECT_EQ(summaries[1].seed_count, 2U);
    EXPECT_DOUBLE_EQ(summaries[1].sah_cost.mean, 7.7);
    EXPECT_DOUBLE_EQ(summaries[1].relative_cost.mean, 1.3);
    // Paired: 12.706 standard errors of two ratios, and not those of two costs.
    EXPECT_NEAR(summaries[1].relative_cost.interval->high, 1.3 + 12.7062 * 0.05, 1e-4);
    EXPECT_EQ(summaries[1].total_seconds.mean, 2.0);
}

TEST(SummarizeSeeds, OneSeedHasNoInterval) {
    const auto summaries = summarize_seeds(std::vector{make_row(10, 1, 10.0, 1.25)});
    ASSERT_EQ(summaries.size(), 1U);
    EXPECT_FALSE(summaries[0].relative_cost.interval);
    EXPECT_EQ(summaries[0].relative_cost.mean, 1.25);
}

}  // namespace

}  // namespace coppice::lab
