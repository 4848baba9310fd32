#include "rows/cost_prediction.h"

#include "statistics/rank_correlation.h"

#include <gmock/gmock.h>

#include <limits>

namespace coppice::lab {

namespace {

using testing::DoubleNear;
using testing::Optional;

TEST(RankCorrelation, OfKnownSamples) {
    const std::vector<double> x{1, 2, 3, 4, 5};
    EXPECT_THAT(rank_correlation(x, std::vector<double>{1, 10, 100, 1e3, 1e9}), Optional(1.0));
    EXPECT_THAT(rank_correlation(x, std::vector<double>{5, 4, 3, 2, 1}), Optional(-1.0));
    // By scipy.stats.spearmanr.
    EXPECT_THAT(rank_correlation(x, std::vector<double>{5, 6, 7, 8, 7}),
                Optional(DoubleNear(0.820782681668123, 1e-12)));
}

TEST(RankCorrelation, NothingWhereItIsNotDefined) {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    EXPECT_EQ(rank_correlation(std::vector<double>{1, 2}, std::vector<double>{1, 2}), std::nullopt);
    EXPECT_EQ(rank_correlation(std::vector<double>{1, 2, 3}, std::vector<double>{7, 7, 7}),
              std::nullopt);
    EXPECT_EQ(rank_correlation(std::vector<double>{1, 2, 3}, std::vector<double>{7, nan, 8}),
              std::nullopt);
}

TEST(Calibrate, FindsTheConstantsThatMadeTheTimes) {
    const std::vector<StepObservation> exact{{10, 5, 45}, {20, 5, 65}, {7, 30, 164}};
    const Calibration found = calibrate(exact).value();
    EXPECT_NEAR(found.traversal, 2.0, 1e-9);
    EXPECT_NEAR(found.intersection, 5.0, 1e-9);
    EXPECT_NEAR(found.rms, 0.0, 1e-9);
    EXPECT_NEAR(calibrate(exact, Residual::relative).value().intersection, 5.0, 1e-9);
    EXPECT_THAT(found.r_squared, Optional(DoubleNear(1.0, 1e-12)));
    EXPECT_EQ(found.count, 3U);
    EXPECT_FALSE(found.is_rank_deficient);
    EXPECT_EQ(caution_of(found, Residual::absolute, 4), "");
    EXPECT_NE(caution_of(found, Residual::absolute, 3), "") << "of three trees only";
}

TEST(Calibrate, TellsHowSureItIs) {
    // X'X is diagonal: the errors are sqrt(s^2 / 2) with s^2 = 4 * 1^2 / (4 - 2).
    const std::vector<StepObservation> noisy{{1, 0, 11}, {1, 0, 9}, {0, 1, 21}, {0, 1, 19}};
    const Calibration found = calibrate(noisy).value();
    EXPECT_NEAR(found.traversal, 10.0, 1e-9);
    EXPECT_THAT(found.traversal_error, Optional(DoubleNear(1.0, 1e-9)));
    EXPECT_THAT(found.intersection_error, Optional(DoubleNear(1.0, 1e-9)));
    const std::vector<StepObservation> wild{{1, 0, 31}, {1, 0, 1}, {0, 1, 1}, {0, 1, 29}};
    EXPECT_THAT(caution_of(calibrate(wild).value(), Residual::absolute, 9),
                testing::HasSubstr("not to be used"));
}

TEST(Calibrate, IsNeverNegative) {
    // Freely it would be -1 and 5: the times fall with the nodes.
    const std::vector<StepObservation> odd{{10, 5, 15}, {20, 5, 5}, {7, 30, 143}};
    const Calibration found = calibrate(odd).value();
    EXPECT_EQ(found.traversal, 0.0);
    EXPECT_NEAR(found.intersection, (5.0 * 15 + 5.0 * 5 + 30.0 * 143) / (25 + 25 + 900), 1e-9);
    EXPECT_GT(found.rms, 1.0);
}

TEST(Calibrate, SaysWhenTheConstantsCannotBeToldApart) {
    const std::vector<StepObservation> same{{10, 5, 40}, {20, 10, 80}, {4, 2, 16}};
    const Calibration found = calibrate(same).value();
    EXPECT_TRUE(found.is_rank_deficient);
    EXPECT_NEAR(found.traversal + found.intersection / 2.0, 4.0, 1e-9);
    EXPECT_FALSE(calibrate(std::vector<StepObservation>{{10, 5, 45}}));
    EXPECT_FALSE(calibrate(std::vector<StepObservation>{{0, 0, 1}, {0, 0, 2}}));
}

ResultRow traced_row(double cost, double nodes, double nanoseconds) {
    ResultRow row;
    row.report.statistics.sah_cost = cost;
    row.rays = {{RayKind::shadow, 1000, 1e-6 * nanoseconds, MeanSteps{nodes, 3.0, 2.0}, 0}};
    return row;
}

TEST(CostPrediction, ByFormOfTree) {
    std::vector<ResultRow> rows{
        traced_row(10, 5, 100), traced_row(20, 9, 90), traced_row(30, 12, 300), {}};
    rows.push_back(traced_row(5, 1, 1));
    rows.back().form = TreeForm::bvh8;
    rows.push_back(traced_row(std::numeric_limits<double>::quiet_NaN(), 1, 1));
    rows.back().form = TreeForm::peer;
    const auto predictions = find_predictions(rows);
    ASSERT_EQ(predictions.size(), 4U);  // all and shadow rays, of k-d and of 8-wide trees
    EXPECT_EQ(predictions[0].tree_count, 3U);
    EXPECT_EQ(predictions[0].rays, "all");
    EXPECT_THAT(predictions[1].with_time, Optional(0.5));
    EXPECT_THAT(predictions[1].with_steps, Optional(1.0));
    EXPECT_EQ(predictions[2].form, TreeForm::bvh8);
    EXPECT_FALSE(predictions[2].with_time) << "of one tree";
    ASSERT_EQ(find_calibrations(rows).size(), 2U) << "by both residuals; two trees at least";
    EXPECT_EQ(find_calibrations(rows)[0].found.count, 3U);
}

}  // namespace

}  // namespace coppice::lab
