#include "rows/recommend.h"

#include <gtest/gtest.h>

#include <limits>

namespace coppice::lab {

namespace {

ResultRow make_row(const char* protocol, double percent, std::uint64_t seed, double cost,
                   double time) {
    ResultRow row;
    row.primitives = "points";
    row.protocol = protocol;
    row.sample_percent = percent;
    row.seed = seed;
    row.relative_cost = cost;
    row.relative_time = time;
    return row;
}

std::vector<Recommendation> knees_of(std::span<const ResultRow> rows) {
    return find_knees(summarize_seeds(rows));
}

TEST(FindKnees, NothingForNoRows) {
    EXPECT_TRUE(knees_of({}).empty());
}

TEST(FindKnees, OneForEachKindAndProtocolInOrder) {
    std::vector<ResultRow> rows{
        make_row("fixed", 100, 1, 1.0, 1.0), make_row("fixed", 50, 1, 1.1, 0.3),
        make_row("fixed", 1, 1, 40.0, 0.1),  make_row("grown", 100, 1, 1.0, 1.0),
        make_row("grown", 50, 1, 1.0, 0.9),  make_row("grown", 1, 1, 1.0, 0.8)};
    for (const double percent : {100.0, 10.0}) {
        rows.push_back(make_row("grown", percent, 1, 1.0, 0.01 * percent));
        rows.back().primitives = "triangles";
    }
    rows.push_back(make_row("alone", 100, 1, 1.0, 1.0));  // nothing to choose from
    const auto recommended = knees_of(rows);
    ASSERT_EQ(recommended.size(), 3U);
    EXPECT_EQ(recommended[0].protocol, "fixed");
    EXPECT_EQ(recommended[0].chosen.percent, 50);
    EXPECT_EQ(recommended[0].chosen.cost, 1.1);
    EXPECT_EQ(recommended[0].chosen.time, 0.3);
    EXPECT_EQ(recommended[1].protocol, "grown");
    EXPECT_EQ(recommended[1].chosen.percent, 1);
    EXPECT_EQ(recommended[2].primitives, "triangles");
}

TEST(FindKnees, AveragesSeeds) {
    // Seed 1 alone would choose 50 %, seed 2 alone 10 %; their means choose 10 %.
    const std::vector<ResultRow> rows{
        make_row("fixed", 100, 1, 1.0, 1.0), make_row("fixed", 50, 1, 1.0, 0.2),
        make_row("fixed", 10, 1, 2.0, 0.3),  make_row("fixed", 1, 1, 5.0, 0.1),
        make_row("fixed", 100, 2, 1.0, 1.0), make_row("fixed", 50, 2, 3.0, 0.8),
        make_row("fixed", 10, 2, 1.5, 0.1),  make_row("fixed", 1, 2, 5.0, 0.1)};
    const auto recommended = knees_of(rows);
    ASSERT_EQ(recommended.size(), 1U);
    EXPECT_EQ(recommended[0].chosen.percent, 10);
    EXPECT_EQ(recommended[0].chosen.cost, 1.75);
    EXPECT_EQ(recommended[0].chosen.time, 0.2);
}

TEST(FindKnees, NothingWhereNoCostIsFinite) {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    const std::vector rows{make_row("fixed", 100, 1, nan, nan)};
    EXPECT_TRUE(knees_of(rows).empty());
    EXPECT_TRUE(recommend(summarize_seeds(rows), 0.02).empty());
}

TEST(Recommend, IsTheSmallestSampleThatIsSurelyWithinTheTolerance) {
    std::vector<ResultRow> rows;
    for (std::uint64_t seed = 1; seed <= 3; ++seed) {
        const double noise = static_cast<double>(seed) - 2.0;
        rows.push_back(make_row("grown", 100, seed, 1.0, 1.0));
        rows.push_back(make_row("grown", 10, seed, 1.005 + 0.001 * noise, 0.5));
        // Within 2 % on average, but not surely: 1.005 +- 0.025.
        rows.push_back(make_row("grown", 1, seed, 1.005 + 0.01 * noise, 0.4));
        rows.push_back(make_row("grown", 0.1, seed, 1.2, 0.3));
        rows.push_back(make_row("fixed", 10, seed, 3.0, 0.3));
    }
    const auto summaries = summarize_seeds(rows);
    const auto recommended = recommend(summaries, 0.02);
    ASSERT_EQ(recommended.size(), 1U) << "fixed has none";
    EXPECT_EQ(recommended[0].protocol, "grown");
    EXPECT_EQ(recommended[0].chosen.percent, 10);
    EXPECT_NEAR(recommended[0].chosen.cost, 1.005, 1e-12);
    EXPECT_TRUE(recommended[0].saves_time());
    EXPECT_FALSE(recommend(summaries, 0.0)[0].saves_time()) << "the full tree";
    EXPECT_EQ(recommend(summaries, 0.031)[0].chosen.percent, 1);
    EXPECT_EQ(recommend(summaries, 0.0)[0].chosen.percent, 100);
    // The mean of the first seed alone, 0.995, is within: there is nothing to doubt it by.
    rows.resize(5);
    EXPECT_EQ(recommend(summarize_seeds(rows), 0.0)[0].chosen.percent, 1);
}

}  // namespace

}  // namespace coppice::lab
