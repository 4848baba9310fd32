#include "sample/uniform.h"

#include "coppice/geom/point_cloud.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <vector>

namespace coppice::test {
namespace {

using Ids = std::vector<std::uint32_t>;

Ids draw_uniform(std::uint32_t of, std::uint32_t count, std::uint64_t seed) {
    const std::vector<Vec3f> points(of);
    return UniformSampler().draw(PointCloudView(points), count, {.seed = seed}).ids;
}

// Draws many times and returns how often each id was drawn, as deviation from the expectation in
// standard deviations.
std::vector<double> inclusion_deviations(std::uint32_t of, std::uint32_t count, int draws) {
    std::vector<int> times(of, 0);
    for (int seed = 0; seed < draws; ++seed) {
        for (const std::uint32_t id : draw_uniform(of, count, static_cast<std::uint64_t>(seed))) {
            ++times[id];
        }
    }
    const double rate = static_cast<double>(count) / of;
    const double expected = rate * draws;
    const double deviation = std::sqrt(draws * rate * (1.0 - rate));
    std::vector<double> deviations;
    deviations.reserve(times.size());
    for (const int drawn : times) {
        deviations.push_back((drawn - expected) / deviation);
    }
    return deviations;
}

TEST(UniformSampler, DrawsEveryIdAlikeOften) {
    for (const std::uint32_t count : {1U, 20U, 150U, 199U}) {
        double squares = 0.0;
        const auto deviations = inclusion_deviations(200, count, 4000);
        for (const double deviation : deviations) {
            EXPECT_LT(std::abs(deviation), 4.5) << "count " << count;
            squares += deviation * deviation;
        }
        // Chi-square of 200 ids: mean 200, standard deviation 20.
        EXPECT_NEAR(squares, 200.0, 100.0) << "count " << count;
    }
}

TEST(UniformSampler, DrawsEveryPairAlikeOften) {
    // Ids 0 and 1 of ten, three at a time: together in 1 of 15.
    constexpr int draws = 15'000;
    int together = 0;
    for (int seed = 0; seed < draws; ++seed) {
        const Ids ids = draw_uniform(10, 3, static_cast<std::uint64_t>(seed));
        together += ids[0] == 0 && ids[1] == 1 ? 1 : 0;
    }
    EXPECT_NEAR(together, draws / 15.0, 4.5 * std::sqrt(draws / 15.0));
}

TEST(UniformSampler, SamplesOfOneSeedAreNested) {
    for (const std::uint64_t seed : {1U, 2U, 3U}) {
        Ids smaller;
        for (const std::uint32_t count : {1U, 2U, 10U, 100U, 101U, 999U, 1000U}) {
            const Ids larger = draw_uniform(1000, count, seed);
            EXPECT_TRUE(
                std::includes(larger.begin(), larger.end(), smaller.begin(), smaller.end()));
            smaller = larger;
        }
    }
}

TEST(UniformSampler, SamplesOfDifferentSeedsAreIndependent) {
    // Two samples of 100 of 1000 share 10 on average, with a standard deviation of 2.7.
    double shared = 0.0;
    constexpr int pairs = 200;
    for (std::uint64_t seed = 0; seed < pairs; ++seed) {
        const Ids first = draw_uniform(1000, 100, seed);
        const Ids second = draw_uniform(1000, 100, seed + 1);
        Ids common;
        std::set_intersection(first.begin(), first.end(), second.begin(), second.end(),
                              std::back_inserter(common));
        shared += static_cast<double>(common.size());
    }
    EXPECT_NEAR(shared / pairs, 10.0, 5.0 * 2.7 / std::sqrt(pairs));
}

}  // namespace
}  // namespace coppice::test
