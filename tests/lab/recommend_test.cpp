#include "lab/recommend.h"

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

TEST(Recommend, NothingForNoRows) {
    EXPECT_TRUE(recommend({}).empty());
}

TEST(Recommend, OneForEachKindAndProtocolInOrder) {
    std::vector<ResultRow> rows{
        make_row("fixed", 100, 1, 1.0, 1.0), make_row("fixed", 50, 1, 1.1, 0.3),
        make_row("fixed", 1, 1, 40.0, 0.1),  make_row("grown", 100, 1, 1.0, 1.0),
        make_row("grown", 50, 1, 1.0, 0.9),  make_row("grown", 1, 1, 1.0, 0.8)};
    rows.push_back(rows.back());
    rows.back().primitives = "triangles";
    const auto recommended = recommend(rows);
    ASSERT_EQ(recommended.size(), 3U);
    EXPECT_EQ(recommended[0].protocol, "fixed");
    EXPECT_EQ(recommended[0].chosen.percent, 50);
    EXPECT_EQ(recommended[0].chosen.cost, 1.1);
    EXPECT_EQ(recommended[0].chosen.time, 0.3);
    EXPECT_EQ(recommended[1].protocol, "grown");
    EXPECT_EQ(recommended[1].chosen.percent, 1);
    EXPECT_EQ(recommended[2].primitives, "triangles");
}

TEST(Recommend, AveragesSeeds) {
    // Seed 1 alone would choose 50 %, seed 2 alone 10 %; their means choose 10 %.
    const std::vector<ResultRow> rows{
        make_row("fixed", 100, 1, 1.0, 1.0), make_row("fixed", 50, 1, 1.0, 0.2),
        make_row("fixed", 10, 1, 2.0, 0.3),  make_row("fixed", 1, 1, 5.0, 0.1),
        make_row("fixed", 100, 2, 1.0, 1.0), make_row("fixed", 50, 2, 3.0, 0.8),
        make_row("fixed", 10, 2, 1.5, 0.1),  make_row("fixed", 1, 2, 5.0, 0.1)};
    const auto recommended = recommend(rows);
    ASSERT_EQ(recommended.size(), 1U);
    EXPECT_EQ(recommended[0].chosen.percent, 10);
    EXPECT_EQ(recommended[0].chosen.cost, 1.75);
    EXPECT_EQ(recommended[0].chosen.time, 0.2);
}

TEST(Recommend, NothingWhereNoCostIsFinite) {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    EXPECT_TRUE(recommend(std::vector{make_row("fixed", 100, 1, nan, nan)}).empty());
}

}  // namespace

}  // namespace coppice::lab
