#include "statistics/knee.h"

#include <gtest/gtest.h>

#include <limits>
#include <map>
#include <string>
#include <vector>

namespace coppice::lab {

namespace {

using Curve = std::vector<KneePoint>;

double knee_percent(const Curve& curve) {
    const auto knee = find_knee(curve);
    return knee ? knee->percent : -1.0;
}

TEST(Knee, NothingForNoPoints) {
    EXPECT_FALSE(find_knee({}).has_value());
}

TEST(Knee, OnePointIsChosen) {
    EXPECT_EQ(knee_percent({{50, 3.0, 2.0}}), 50);
}

TEST(Knee, TheBendOfACurve) {
    // From 100 to 20 % much time is saved for little cost, then the other way round.
    EXPECT_EQ(knee_percent({{100, 1.0, 10.0}, {50, 1.05, 6.0}, {20, 1.1, 2.0}, {1, 3.0, 1.0}}), 20);
}

TEST(Knee, EqualCostsGiveTheFastest) {
    EXPECT_EQ(knee_percent({{100, 1.0, 5.0}, {50, 1.0, 1.0}, {10, 1.0, 2.0}}), 50);
}

TEST(Knee, EqualTimesGiveTheCheapest) {
    EXPECT_EQ(knee_percent({{100, 1.5, 1.0}, {50, 1.2, 1.0}, {10, 1.3, 1.0}}), 50);
}

TEST(Knee, AllEqualGivesTheLargestPercentage) {
    EXPECT_EQ(knee_percent({{1, 1.0, 1.0}, {100, 1.0, 1.0}, {50, 1.0, 1.0}}), 100);
}

TEST(Knee, TwoPointsTieAndTheCheaperWins) {
    EXPECT_EQ(knee_percent({{50, 2.0, 1.0}, {100, 1.0, 2.0}}), 100);
}

TEST(Knee, OrderDoesNotMatter) {
    const Curve forwards{{100, 1.0, 10.0}, {50, 1.1, 6.0}, {20, 1.2, 2.0}, {1, 3.0, 1.0}};
    EXPECT_EQ(knee_percent(forwards), knee_percent({forwards.rbegin(), forwards.rend()}));
}

TEST(Knee, ScaleDoesNotMatter) {
    Curve curve{{100, 1.0, 10.0}, {50, 1.1, 6.0}, {20, 1.2, 2.0}, {1, 3.0, 1.0}};
    for (KneePoint& point : curve) {
        point.cost = point.cost * 512.0 + 64.0;
        point.time *= 0.125;
    }
    EXPECT_EQ(knee_percent(curve), 20);
}

TEST(Knee, NeverADominatedPoint) {
    // Non-monotonic: 50 % is slower and costlier than 40 %, and 10 % costs less than 20 %.
    const Curve curve{{100, 1.0, 9.0}, {50, 1.4, 6.0}, {40, 1.3, 5.0},
                      {20, 1.9, 2.0},  {10, 1.6, 1.5}, {1, 2.5, 1.0}};
    const auto knee = find_knee(curve);
    ASSERT_TRUE(knee.has_value());
    for (const KneePoint& point : curve) {
        EXPECT_FALSE(point.cost < knee->cost && point.time < knee->time) << point.percent;
    }
    EXPECT_EQ(knee->percent, 10);
}

TEST(Knee, PointsThatAreNotFiniteArePassedOver) {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    const double infinity = std::numeric_limits<double>::infinity();
    EXPECT_EQ(knee_percent({{100, nan, 1.0}, {50, 1.0, infinity}, {10, 2.0, 2.0}}), 10);
    EXPECT_FALSE(find_knee(Curve{{100, nan, nan}}).has_value());
}

TEST(Knee, HugeNumbersDoNotOverflow) {
    EXPECT_EQ(
        knee_percent({{100, -1.7e308, 1.7e308}, {50, -1.6e308, -1.6e308}, {1, 1.7e308, -1.7e308}}),
        50);
}

// The thesis's own costs and build seconds ([Tsiompikas2022] fig. 3 and 4). It says 50 %, by eye.
TEST(Knee, TheThesisTable) {
    const std::map<std::string, Curve> scenes{{"living room",
                                               {{100, 13.379, 42},
                                                {50, 16.2415, 23},
                                                {40, 18.0391, 18},
                                                {30, 20.7466, 13},
                                                {20, 22.5436, 9},
                                                {10, 25.007, 4},
                                                {5, 27.7984, 2},
                                                {4, 29.9927, 1},
                                                {3, 32.8045, 1},
                                                {2, 34.4543, 0},
                                                {1, 36.5801, 0}}},
                                              {"bmw",
                                               {{100, 20.3705, 267},
                                                {50, 21.8756, 138},
                                                {40, 23.3739, 115},
                                                {30, 26.2615, 90},
                                                {20, 28.2949, 56},
                                                {10, 30.2203, 27},
                                                {5, 31.6427, 13},
                                                {4, 32.889, 10},
                                                {3, 35.2765, 7},
                                                {2, 37.9099, 4},
                                                {1, 39.3723, 2}}},
                                              {"bistro",
                                               {{100, 22.3338, 382},
                                                {50, 23.1208, 203},
                                                {40, 25.8116, 165},
                                                {30, 27.2772, 120},
                                                {20, 28.5868, 84},
                                                {10, 30.1757, 46},
                                                {5, 32.141, 21},
                                                {4, 34.0449, 15},
                                                {3, 36.8446, 11},
                                                {2, 39.6257, 7},
                                                {1, 42.5385, 3}}},
                                              {"dragon",
                                               {{100, 29.94, 737},
                                                {50, 32.0152, 405},
                                                {40, 33.6649, 379},
                                                {30, 34.975, 258},
                                                {20, 37.7269, 182},
                                                {10, 39.8926, 86},
                                                {5, 41.9352, 42},
                                                {4, 43.0366, 32},
                                                {3, 45.2008, 21},
                                                {2, 47.5889, 13},
                                                {1, 49.1755, 6}}}};
    std::map<std::string, double> chosen;
    for (const auto& [scene, curve] : scenes) {
        chosen[scene] = knee_percent(curve);
    }
    const std::map<std::string, double> expected{
        {"living room", 10}, {"bmw", 40}, {"bistro", 10}, {"dragon", 30}};
    EXPECT_EQ(chosen, expected);
}

}  // namespace

}  // namespace coppice::lab
