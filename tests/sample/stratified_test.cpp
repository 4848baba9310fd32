#include "sample/stratified.h"

#include "coppice/geom/point_cloud.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace coppice::test {
namespace {

// How many of `count` draws fall below each multiple of 1/8 along x, at most off by so many.
double worst_gap(const std::vector<Vec3f>& points, std::uint32_t count, std::uint64_t seed) {
    const Sample sample = StratifiedSampler().draw(PointCloudView(points), count, {.seed = seed});
    double worst = 0.0;
    for (int eighth = 1; eighth < 8; ++eighth) {
        double below = 0.0;
        for (const std::uint32_t id : sample.ids) {
            below += points[id].x < static_cast<float>(eighth) / 8.0F ? 1.0 : 0.0;
        }
        worst = std::max(worst, std::abs(below - count * eighth / 8.0));
    }
    return worst;
}

TEST(StratifiedSampler, LeavesNoGapAlongALine) {
    std::vector<Vec3f> points;
    for (int i = 0; i < 8192; ++i)  // in an order that says nothing of the place
        points.push_back({static_cast<float>(i * 3571 % 8192) / 8192.0F, 0.0F, 0.0F});
    for (std::uint64_t seed = 1; seed < 20; ++seed) {
        EXPECT_LE(worst_gap(points, 256, seed), 2.0) << "uniform draws: about 8";
    }
}

TEST(StratifiedSampler, GivesAllTheSameWeight) {
    const std::vector<Vec3f> points(100);
    const Sample sample = StratifiedSampler().draw(PointCloudView(points), 25, {.seed = 1});
    for (const float weight : sample.weights) {
        EXPECT_FLOAT_EQ(weight, 4.0F);
    }
}

}  // namespace
}  // namespace coppice::test
