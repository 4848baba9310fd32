#include "report/chart_labels.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace coppice::report {
namespace {

constexpr PlotPoint corner{500, 300};

LabelPoint point_at(double x, double y, std::size_t line, double priority = 0.0) {
    return {.at = {x, y}, .line = line, .width = 30, .priority = priority};
}

TEST(PlaceLabels, ALonePointIsLabelled) {
    EXPECT_EQ(place_labels({point_at(250, 150, 0)}, corner), (std::vector{LabelSide::above_right}));
    EXPECT_TRUE(place_labels({}, corner).empty());
}

TEST(PlaceLabels, LabelsStayInThePlot) {
    EXPECT_EQ(place_labels({point_at(498, 150, 0)}, corner), (std::vector{LabelSide::below_left}));
    EXPECT_EQ(place_labels({point_at(250, 6, 0)}, corner), (std::vector{LabelSide::right}));
}

TEST(PlaceLabels, OfPointsInOnePlaceTheMostImportantIsLabelled) {
    const auto sides = place_labels(
        {point_at(250, 150, 0), point_at(250, 150, 1, 2.0), point_at(251, 150, 2)}, corner);
    EXPECT_EQ(sides[1], LabelSide::above_right);
    // The others find other sides, or none, but never the same one.
    EXPECT_NE(sides[0], LabelSide::above_right);
    EXPECT_NE(sides[2], LabelSide::above_right);
}

TEST(PlaceLabels, LabelsKeepOffTheirLine) {
    // A line that rises steeply to the right takes the places above right of and above its points.
    const auto sides =
        place_labels({point_at(100, 280, 0), point_at(150, 160, 0), point_at(200, 40, 0)}, corner);
    EXPECT_EQ(sides[1], LabelSide::right);
    // Without the line they are free.
    const auto loose =
        place_labels({point_at(100, 280, 0), point_at(150, 160, 1), point_at(200, 40, 2)}, corner);
    EXPECT_EQ(loose[1], LabelSide::above_right);
}

TEST(PlaceLabels, ACrowdGetsFewerLabelsThanPoints) {
    std::vector<LabelPoint> crowd;
    crowd.reserve(50);
    for (int i = 0; i < 50; ++i) {
        crowd.push_back(point_at(250 + i, 150, 0));
    }
    const auto sides = place_labels(crowd, corner);
    const auto unlabelled = std::ranges::count(sides, LabelSide::none);
    EXPECT_GT(unlabelled, 30);
    EXPECT_LT(unlabelled, 50);
}

}  // namespace
}  // namespace coppice::report
